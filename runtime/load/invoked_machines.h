// The machines that a file runs inside: what <Machine> nodes name, files that `src` names, machines
// that <content> spells, those that a srcexpr may name, and what these invoke. Each is compiled
// once. Private to runtime/load. Covered by tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/program.h"
#include "load/builder.h"

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

class InvokedMachines {
public:
    /// `outermost` is the builder of the file that is loaded, and outlives this.
    explicit InvokedMachines(Builder& outermost) : outermost_(outermost) {}

    /// The machine file `path`, as the file `from` names it at `where`; none after an error.
    MachineId file(std::string_view path, const ReadFile& from, Where where);
    /// The machine that an element of `file`, which outlives this, spells.
    MachineId element(const ReadFile& file, ElementId machine);
    /// The machine that `text` may stand for when a document computes its source: the path of a
    /// machine file, or a machine itself. None, without an error, if it is neither.
    MachineId source(std::string_view text, const ReadFile& from);

    /// The names of the variables that whoever invokes a machine may set, its top-level <data>,
    /// sorted.
    const std::vector<std::string_view>& variables(MachineId machine);

    /// Compiles all of them into Program::machines of the outermost program.
    void compile();

private:
    struct Machine {
        const ReadFile* file;
        ElementId root;
        std::string name;  ///< of the file; empty: it stands inside one
        std::optional<std::vector<std::string_view>> variables = {};  ///< once asked for
    };

    std::optional<Source> find(std::string_view path, const ReadFile& from) const;
    MachineId add(std::optional<Document> document, Source source);

    Builder& outermost_;
    std::deque<ReadFile> files_;
    std::vector<Machine> machines_;
};

/// A file as SCXML names it: "file:x.scxml" and "file://x.scxml" are x.scxml.
std::string_view path_of_uri(std::string_view uri);

}  // namespace trellis
