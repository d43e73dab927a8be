// The W3C's implementation-report tests, in both spellings: each that uses only what Trellis has
// must end in the state that the manifest names, or be refused where it allows that.
// SPDX-License-Identifier: MIT
#include "load/json_tree.h"
#include "load/load.h"
#include "support/files.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace trellis::test {
namespace {

/// The top-level final state that a machine ends in; "-" if it does not end.
std::string end_of(const Program& program) {
    ScriptRun run(program);
    for (int cycle = 0; cycle < 50 && !run.state.session.final && !run.state.fault; ++cycle) {
        run.step();
    }
    if (run.state.fault) { return describe_fault(program, run.state); }
    return run.state.session.final ? std::string(program.name(run.state.session.final)) : "-";
}

struct Outcome {
    bool not_yet = false;  ///< it uses an element or attribute that this version does not run
    std::string end;       ///< a state, or "rejected: …"
};

Outcome outcome_of(const std::filesystem::path& path) {
    Diagnostics diagnostics;
    const std::optional<Program> program =
        load({path.filename().string(), read_file(path)}, script_registry(), diagnostics);
    Outcome out;
    if (program) {
        out.end = end_of(*program);
        return out;
    }
    for (const Diagnostic& d : diagnostics.all()) {
        const bool child_machine = d.id == "bad-value" && d.message.ends_with("\"scxml\"");
        out.not_yet |= d.id == "not-run" || child_machine;
    }
    out.end = "rejected: " + diagnostics.render();
    return out;
}

}  // namespace

TEST_CASE("machine cases: the W3C's tests end as their manifest says") {
    const std::filesystem::path folder = TRELLIS_CONFORMANCE_DIR "/machines";
    if (!std::filesystem::exists(folder)) {
        MESSAGE("no recorded machines in " TRELLIS_CONFORMANCE_DIR);
        return;
    }
    Diagnostics diagnostics;
    const std::optional<JsonTree> manifest =
        parse_json(read_file(folder / "manifest.json"), 0, diagnostics);
    REQUIRE(manifest.has_value());
    const JsonTree& m = *manifest;
    std::size_t passed = 0;
    std::size_t not_yet = 0;
    for (const JsonId test : m.children(m.member(m.root(), "tests"))) {
        const JsonId check = m.member(test, "check");
        const JsonId final = m.member(check, "final");
        const std::string_view wanted = final ? m.text(final) : "rejected";
        const bool may_reject = m.member(check, "load") || m.member(check, "or_load");
        std::filesystem::path path = folder / m.text(m.member(test, "file"));
        for (const char* spelling : {".scxml", ".json"}) {
            path.replace_extension(spelling);
            const Outcome outcome = outcome_of(path);
            if (outcome.not_yet) {
                ++not_yet;
                continue;
            }
            const bool rejected = may_reject && outcome.end.starts_with("rejected");
            const std::string name = path.filename().string();
            CAPTURE(name);
            CHECK((rejected ? wanted : std::string_view(outcome.end)) == wanted);
            ++passed;
        }
    }
    MESSAGE(passed, " files run to their end, ", not_yet, " use elements that do not exist yet");
}

}  // namespace trellis::test
