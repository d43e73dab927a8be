// machine_driver FILE [EVENT...]: runs a machine file and prints the ids of its active states,
// sorted, at the start and after each event, a line each. Uses the installed headers only. The same
// comparison is made by tests/exec/machine_cases_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/leaf.h"
#include "core/program.h"
#include "core/state.h"
#include "exec/step.h"
#include "load/load.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>

namespace {

void print_configuration(const trellis::Program& program, const trellis::State& state) {
    std::set<std::string> ids;
    for (const trellis::RowId n : state.session.active) {
        ids.emplace(program.name(n));
    }
    std::string line;
    for (const std::string& id : ids) {
        line += (line.empty() ? "" : " ") + id;
    }
    std::puts(line.c_str());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: machine_driver FILE [EVENT...]\n", stderr);
        return 2;
    }
    std::ifstream file(argv[1], std::ios::binary);
    if (!file) {
        std::fprintf(stderr, "cannot read %s\n", argv[1]);
        return 3;
    }
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const trellis::Registry registry;
    trellis::Diagnostics diagnostics;
    const std::optional<trellis::Program> program =
        trellis::load({argv[1], text}, registry, diagnostics);
    if (!program || !program->is_machine()) {
        std::fputs(diagnostics.render().c_str(), stderr);
        return 1;
    }
    trellis::State state = trellis::fresh_state(*program);
    trellis::start(*program, state, {});
    print_configuration(*program, state);
    for (int i = 2; i < argc; ++i) {
        if (!state.fault && !state.session.final) {
            trellis::send(*program, state, argv[i]);
            trellis::step(*program, state, {});
        }
        print_configuration(*program, state);
    }
    if (!state.fault) { return 0; }
    std::fprintf(stderr, "%s\n", trellis::describe_fault(*program, state).c_str());
    return 1;
}
