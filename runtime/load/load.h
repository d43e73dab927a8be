// From the text of a behaviour file to a Program, in one call: read, check, compile. The stages are
// in xml.h and json.h (text to Document), check.h (Document against the grammar) and compile.h
// (Document to Program). Nothing here opens files: the caller passes texts.
// Covered by tests/load/load_test.cpp and, for every message, tests/load/faults_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "load/diagnostics.h"
#include "load/document.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

/// A named text: what a file is to the loader.
struct Source {
    std::string name;  ///< as messages show it
    std::string text;
};

/// Where the texts of <include> and of `src` attributes come from.
class SourceReader {
public:
    virtual ~SourceReader() = default;
    /// The text called `path`, which was written in the text called `from` (relative paths are
    /// relative to its folder); empty if there is none. `package` is the include's ros_pkg, or
    /// empty.
    virtual std::optional<Source> read(std::string_view path, std::string_view from,
                                       std::string_view package) = 0;
};

struct LoadOptions {
    SourceReader* reader = nullptr;   ///< null: a file that refers to another is an error
    std::string_view main_tree = {};  ///< ID of the tree to run; empty: what the file says
    /// Variables that the host sets before the run, and their values as text: of the main tree's
    /// blackboard, or top-level <data> of a machine. "path/name" names one inside a subtree.
    std::vector<std::pair<std::string, std::string>> given = {};
    /// Rules that put other nodes in the place of some, to test a tree without its robot; null:
    /// none. JSON as BehaviorTree.CPP loads it: {"TestNodeConfigs": {NAME: {…}},
    /// "SubstitutionRules": {PATTERN: NAME}}. A pattern is the name or the type of a node, or its
    /// path with * and ?; the first that matches counts. A type that a rule names need not be
    /// known. The text is needed during load() only.
    const Source* substitutions = nullptr;
    DocumentLimits limits = {};
    std::uint32_t rows = 1'048'576;  ///< of a program, with all subtrees expanded
    std::uint32_t includes = 1000;   ///< that are read; what they name obeys `limits` together
};

/// Reads XML or JSON, whichever the text is; empty if it is not well formed. The text is moved to
/// `diagnostics`, as the next file there.
std::optional<Document> read(Source source, Diagnostics& diagnostics,
                             const LoadOptions& options = {});

/// The name under which LoadOptions::given sets a variable: its own, behind that of the subtrees it
/// is in, "path/name".
std::string path_of(const Program& program, const Slot& slot);

/// What the document is; one with another root is taken for what that resembles more.
FileKind kind_of(const Document& document);

/// The whole way. Empty if there was any error; `diagnostics` then holds all of them, sorted.
/// `registry` must outlive the program.
std::optional<Program> load(Source source, const Registry& registry, Diagnostics& diagnostics,
                            const LoadOptions& options = {});

}  // namespace trellis
