// trellis nodes: the palette.
// SPDX-License-Identifier: MIT
#include "runner/choice.h"
#include "runner/commands.h"
#include "runner/palette.h"

#include <CLI/CLI.hpp>

#include <ostream>

namespace trellis {

void add_options(CLI::App& app, NodesArguments& arguments) {
    using Spelling = NodesArguments::Spelling;
    add_choice<Spelling>(
        app, "--format", arguments.format,
        {{"text", Spelling::text}, {"json", Spelling::json}, {"xml", Spelling::xml}},
        "how to write the palette; xml: a TreeNodesModel of the leaves, for Groot2");
    const auto shorthand = [&](const std::string& name, Spelling spelling) {
        app.add_flag_callback(
               "--" + name, [&arguments, spelling] { arguments.format = spelling; },
               "short for --format " + name)
            ->excludes("--format");
    };
    shorthand("text", Spelling::text);
    shorthand("json", Spelling::json);
    shorthand("xml", Spelling::xml);
}

Exit execute(const NodesArguments& arguments, Streams& streams) {
    const RoombaRegistry registry;
    switch (arguments.format) {
    case NodesArguments::Spelling::text: streams.out << palette_text(registry); break;
    case NodesArguments::Spelling::json: streams.out << palette_json(registry); break;
    case NodesArguments::Spelling::xml: streams.out << palette_xml(registry); break;
    }
    return Exit::yes;
}

}  // namespace trellis
