// trellis schema: the grammars that the loader checks by, for editors and other validators.
// SPDX-License-Identifier: MIT
#include "load/diagnostics.h"
#include "load/grammar.h"
#include "load/schema_json.h"
#include "load/schema_xsd.h"
#include "runner/commands.h"
#include "runner/sweep/spec.h"
#include "sim/bridge/world_grammar.h"

#include <CLI/CLI.hpp>

#include <ostream>

namespace trellis {

namespace {

using Write = std::string (*)(const Registry&);

struct Schema {
    std::string_view name;
    Write write;
};

constexpr Schema schemas[] = {
    {"tree-xsd", [](const Registry& registry) { return xsd(tree_grammar(registry)); }},
    {"machine-xsd", [](const Registry&) { return xsd(machine_grammar()); }},
    {"tree-json", [](const Registry& registry) { return json_schema(tree_grammar(registry)); }},
    {"machine-json", [](const Registry&) { return json_schema(machine_grammar()); }},
    {"sweep-json", [](const Registry&) { return file_schema(sweep_grammar()); }},
    {"world-json", [](const Registry&) { return file_schema(world_grammar()); }},
};

}  // namespace

void add_options(CLI::App& app, SchemaArguments& arguments) {
    app.add_option("NAME", arguments.name,
                   "tree-xsd, machine-xsd, tree-json, machine-json, world-json or sweep-json")
        ->required();
}

Exit execute(const SchemaArguments& arguments, Streams& streams) {
    std::vector<std::string_view> names;
    for (const Schema& schema : schemas) {
        if (schema.name == arguments.name) {
            const RoombaRegistry registry;
            streams.out << schema.write(registry);
            return Exit::yes;
        }
        names.push_back(schema.name);
    }
    return complain(streams, Exit::usage,
                    "there is no schema \"" + arguments.name + '"' +
                        suggestion(arguments.name, names));
}

}  // namespace trellis
