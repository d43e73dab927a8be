// What the compilers of trees and machines share: adding rows, code and leaf calls to a Program,
// with diagnostics at the place in the document. Private to runtime/load. Covered by
// tests/load/compile_tree_test.cpp and tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/leaf.h"
#include "core/program.h"
#include "load/diagnostics.h"
#include "load/document.h"
#include "load/emit.h"
#include "load/grammar.h"
#include "load/load.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace trellis {

struct Substitutions;

/// One file that was read.
struct ReadFile {
    std::string name;
    Document document;
};

/// A program while it is being built.
class Builder {
public:
    /// `trees` is the grammar of tree files, for included and invoked ones.
    Builder(const Registry& registry, const Grammar& trees, Diagnostics& diagnostics,
            const LoadOptions& options)
        : registry_(registry), trees_(trees), diagnostics_(diagnostics), options_(options) {}

    Program program;
    Substitutions* substitutions = nullptr;  ///< null: no node is replaced
    std::vector<SlotId> unset = {};          ///< of trees: what nothing gives a value, sorted

    const Registry& registry() const { return registry_; }
    const Grammar& grammar() const { return trees_; }
    Diagnostics& diagnostics() { return diagnostics_; }
    const LoadOptions& options() const { return options_; }

    /// Makes room for that many rows: to be called once, if they can be estimated.
    void reserve(std::size_t rows);
    /// Adds a row below `parent` (none for row 0); close it after its last child. None, and an
    /// error, if the program would get too large or too deep.
    RowId open(Op op, RowId parent, std::string_view name, Where where, std::uint32_t arg = 0);
    void close(RowId n) { program.rows[n.index].end = {next_row()}; }
    /// True once open() has refused a row: the rest need not be tried.
    bool is_full() const { return full_; }

    SlotId add_slot(std::string_view name, RowId scope);
    /// Gives a variable the value it has before the first tick, and the entry type of that value.
    void set_initial(SlotId slot, Value value);
    /// What _x.NAME means: see Names::sensor.
    Meaning sensor(std::string_view name);
    /// Lets texts of the program name enumerators at run time.
    void name_enumerators();
    /// The value of a literal: as literal_value(), the number if it is the name of an enumerator.
    Value enumerated(std::string_view literal) const;

    /// A script or expression in a file: the value of an attribute, or character data.
    struct Text {
        const ReadFile* file = nullptr;
        std::string_view text;  ///< decoded; owned by the file's document
        Where where;            ///< of its first character
    };
    static Text text_of(const ReadFile& file, const Attribute& attribute) {
        return {&file, file.document.string(attribute.value), attribute.value_where};
    }
    static Text text_of(const ReadFile& file, ElementId e) {
        return {&file, file.document.text(e), file.document.at(e).text_where};
    }
    /// Where a byte of it stands in its file.
    Where place_in(const Text& text, std::size_t offset) const;
    /// Where the name first stands in it as a word; its beginning if it does not.
    Where place_of(const Text& text, std::string_view name) const;

    /// The first word directly before a "(" that is no function, in a tree: BehaviorTree.CPP reads
    /// two expressions there, but a misspelt function is meant. Empty if there is none.
    static std::string_view unknown_call(const Text& text);
    void report_unknown_call(const Text& text, std::string_view name);

    /// Compiles a script or expression; none, and errors, if it has faults.
    CodeId expression(const Text& text, Dialect dialect, SyntaxMode mode, Names& names);
    /// Compiles where an <assign> writes to: see emit_store().
    CodeId store(const Text& text, Names& names);
    /// Code whose value is `value`, or what a variable holds.
    CodeId constant(Value value, Dialect dialect);
    CodeId variable(SlotId slot, Dialect dialect);

    /// Adds a use of a leaf with its defaults; set its ports before adding another.
    std::uint32_t add_call(const LeafType& type);
    /// Sets an input of the call added last to a literal; false if it does not convert.
    bool set_literal(const Port& port, Value value);
    /// Likewise, to a text that is converted, or that names an enumerator.
    bool set_literal(const Port& port, std::string_view text);
    /// Sets an input of the call added last to what `code` gives before each tick.
    void set_live(const Port& port, CodeId code);
    void set_output(const Port& port, SlotId slot);

private:
    std::optional<Syntax> parse(const Text& text, Dialect dialect, SyntaxMode mode);
    CodeId checked(const Text& text, CodeId code, const std::vector<EmitError>& errors);
    std::uint32_t next_row() const { return static_cast<std::uint32_t>(program.rows.size()); }
    std::uint32_t port_index(const Port& port) const;
    CodeId add_copy(Operand operand, Dialect dialect);
    const std::int64_t* enumerator(std::string_view name) const;
    std::uint32_t name_index(std::string_view name);
    bool write_literal(const Port& port, Value& value);

    const Registry& registry_;
    const Grammar& trees_;
    Diagnostics& diagnostics_;
    const LoadOptions& options_;
    std::vector<std::uint32_t> depths_;  // by row
    bool full_ = false;
    std::unordered_map<std::string, std::uint32_t> name_index_;  // into program.names.texts
    Value literal_;  // scratch of set_literal(): its buffer is used again
};

/// The key of a blackboard pointer: "key" of "{key}"; `port` itself of "{=}".
std::string_view pointer_key(std::string_view value, std::string_view port);

/// `value` as BehaviorTree.CPP types an untyped literal: integer, real, else text (TREES §2.3).
Value literal_value(std::string_view value);

}  // namespace trellis
