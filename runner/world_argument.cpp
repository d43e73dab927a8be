// Reading a world file from the disk.
// SPDX-License-Identifier: MIT
#include "runner/world_argument.h"

#include "load/diagnostics.h"
#include "runner/behaviour.h"
#include "sim/bridge/world_file.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace trellis {

namespace {

const CLI::Validator world_name(
    [](const std::string& name) {
        const bool known = name == "lab" || name == "none" || name.ends_with(".json");
        return known ? std::string()
                     : "expected lab, none or FILE.json, found \"" + name + '"' +
                           suggestion(name, {"lab", "none"});
    },
    "", "world_name");

}  // namespace

void add_option(CLI::App& app, WorldArgument& argument) {
    app.add_option("--world", argument.name,
                   "the lab's room, a world file, or none: no robot at all; then only "
                   "\"final: ID\" is printed")
        ->type_name("lab|none|FILE.json")
        ->check(world_name);
}

std::optional<WalledWorld> load_world(const std::string& file, Streams& streams, Exit& exit) {
    exit = Exit::file;
    const std::optional<std::string> text = read_text(file, streams);
    if (!text) { return {}; }
    Diagnostics diagnostics;
    const std::uint32_t number = diagnostics.add_file(shown_name(file), *text);
    std::optional<World> world = read_world(*text, number, diagnostics);
    diagnostics.sort();
    show(diagnostics, streams);
    exit = Exit::no;
    if (!world) { return {}; }
    exit = Exit::yes;
    return WalledWorld(std::move(*world));
}

}  // namespace trellis
