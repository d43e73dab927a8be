// Finding, reading and compiling machines that are invoked.
// SPDX-License-Identifier: MIT
#include "load/invoked_machines.h"

#include "load/check.h"
#include "load/compile.h"
#include "load/grammar.h"
#include "load/machine_compiler.h"
#include "load/text.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace trellis {

std::string_view path_of_uri(std::string_view uri) {
    if (!uri.starts_with("file:")) { return uri; }
    uri.remove_prefix(5);
    if (uri.starts_with("//")) { uri.remove_prefix(2); }
    return uri;
}

std::optional<Source> InvokedMachines::find(std::string_view path, const ReadFile& from) const {
    SourceReader* const reader = outermost_.options().reader;
    if (reader == nullptr) { return {}; }
    return reader->read(path_of_uri(path), from.name, {});
}

MachineId InvokedMachines::file(std::string_view path, const ReadFile& from, Where where) {
    std::optional<Source> source = find(path, from);
    Diagnostics& diagnostics = outermost_.diagnostics();
    if (!source) {
        diagnostics.error("unreadable-file", where, "cannot read \"" + std::string(path) + "\"");
        return {};
    }
    // a file that is invoked twice, or invokes itself, is one machine
    for (std::uint32_t i = 0; i < machines_.size(); ++i) {
        if (machines_[i].name == source->name) { return {i}; }
    }
    std::optional<Document> document = read(*source, diagnostics, outermost_.options());
    return add(std::move(document), std::move(*source));
}

MachineId InvokedMachines::add(std::optional<Document> document, Source source) {
    if (!document) { return {}; }
    check(*document, machine_grammar(), outermost_.diagnostics());
    const ReadFile& file =
        files_.emplace_back(ReadFile{std::move(source.name), std::move(*document)});
    machines_.push_back({&file, file.document.root(), file.name});
    return {static_cast<std::uint32_t>(machines_.size() - 1)};
}

MachineId InvokedMachines::element(const ReadFile& file, ElementId machine) {
    machines_.push_back({&file, machine, {}});
    return {static_cast<std::uint32_t>(machines_.size() - 1)};
}

MachineId InvokedMachines::source(std::string_view text, const ReadFile& from) {
    if (trimmed(text).starts_with('<')) {
        Source source{from.name + ", in a text", std::string(text)};
        Diagnostics own;
        std::optional<Document> document = read(source, own, outermost_.options());
        if (!document || document->name(document->root()) != "scxml") { return {}; }
        document = read(source, outermost_.diagnostics(), outermost_.options());
        return add(std::move(document), std::move(source));
    }
    const bool is_path =
        text.ends_with(".scxml") || text.ends_with(".xml") || text.ends_with(".json");
    if (!is_path) { return {}; }
    const std::optional<Source> source = find(text, from);
    if (!source) { return {}; }
    Diagnostics own;
    const std::optional<Document> document = read(*source, own, outermost_.options());
    if (!document || file_kind(*document) != FileKind::machine) { return {}; }
    return file(text, from, {});
}

const std::vector<std::string_view>& InvokedMachines::variables(MachineId machine) {
    Machine& known = machines_[machine.index];
    if (known.variables) { return *known.variables; }
    const Document& document = known.file->document;
    std::vector<std::string_view>& names = known.variables.emplace();
    for (const ElementId model : document.children(known.root)) {
        if (document.name(model) != "datamodel") { continue; }
        for (const ElementId data : document.children(model)) {
            names.push_back(document.value(data, "id"));
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

namespace {

/// By machine: the numbers of the variables that whoever invokes it may set.
using Variables = std::vector<std::unordered_map<std::string_view, SlotId>>;

Variables variables_of(const std::vector<Program>& machines) {
    Variables all(machines.size());
    for (std::size_t i = 0; i < machines.size(); ++i) {
        for (const SlotId variable : machines[i].parameters) {
            all[i][machines[i].slots[variable.index].name] = variable;
        }
    }
    return all;
}

/// Now that all machines are compiled, the variables that nodes give values to have numbers.
void resolve_params(Program& program, const Variables& variables) {
    for (const MachineNode& node : program.machine_nodes) {
        if (!node.machine) { continue; }  // reported before
        const auto& known = variables[node.machine.index];
        for (std::uint32_t i = 0; i < node.param_count; ++i) {
            MachineParam& param = program.machine_params[node.first_param + i];
            if (const auto found = known.find(param.name); found != known.end()) {
                param.variable = found->second;
            }
        }
    }
}

}  // namespace

// A machine may invoke others, which are added behind it.
void InvokedMachines::compile() {
    std::vector<Program> programs;
    for (std::size_t i = 0; i < machines_.size(); ++i) {
        const Machine machine = machines_[i];
        Builder builder(outermost_.registry(), outermost_.grammar(), outermost_.diagnostics(),
                        outermost_.options());
        builder.substitutions = outermost_.substitutions;
        MachineCompiler(builder, *machine.file, machine.root, *this).machine();
        builder.name_enumerators();
        if (builder.program.host != nullptr) { outermost_.program.host = builder.program.host; }
        programs.push_back(std::move(builder.program));
    }
    const Variables variables = variables_of(programs);
    resolve_params(outermost_.program, variables);
    for (Program& program : programs) {
        resolve_params(program, variables);
    }
    outermost_.program.machines = std::move(programs);
}

}  // namespace trellis
