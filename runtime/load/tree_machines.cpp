// Machines as nodes of trees: part of tree_compiler.h. The machines themselves are found and
// compiled in invoked_machines.h. Covered by tests/exec/machine_node_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/attribute_rule.h"
#include "load/tree_compiler.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

std::uint32_t TreeCompiler::machine(const Place& place) {
    Program& program = builder_.program;
    MachineNode node{.first_param = static_cast<std::uint32_t>(program.machine_params.size())};
    if (const Attribute* source = document(place).find(place.element, "src"); source != nullptr) {
        node.machine =
            machines_.file(document(place).string(source->value), *place.file, source->value_where);
    }
    for (const Attribute& attribute : document(place).attributes_of(place.element)) {
        const std::string_view name = document(place).string(attribute.name);
        if (name == "name" || name == "src" || name.starts_with('_')) { continue; }
        program.machine_params.push_back(machine_param(place, node.machine, attribute));
        ++node.param_count;
    }
    program.machine_nodes.push_back(node);
    return static_cast<std::uint32_t>(program.machine_nodes.size() - 1);
}

MachineParam TreeCompiler::machine_param(const Place& place, MachineId machine,
                                         const Attribute& attribute) {
    const std::string_view name = document(place).string(attribute.name);
    const std::string_view value = document(place).string(attribute.value);
    if (machine) {
        const std::vector<std::string_view>& known = machines_.variables(machine);
        if (!std::binary_search(known.begin(), known.end(), name)) {
            builder_.diagnostics().error("unknown-port", attribute.where,
                                         "this machine has no variable \"" + std::string(name) +
                                             '"' + suggestion(name, known));
        }
    }
    MachineParam param{.name = std::string(name), .variable = {}, .entry = {}};
    if (is_pointer(value)) {
        param.entry = scopes_.variable(place.scope, pointer_key(value, name));
        scopes_.written(param.entry);
    } else {
        param.value = literal_value(value);
    }
    return param;
}

}  // namespace trellis
