// The W3C's implementation-report tests, in both spellings: each ends in the state that its
// manifest names, or is refused where that is asked for, logs what it should, and its twins are
// equal programs. And the recorded random statecharts: the same configurations after each event.
// SPDX-License-Identifier: MIT
#include "load/json_tree.h"
#include "load/load.h"
#include "support/configuration.h"
#include "support/disk.h"
#include "support/files.h"
#include "support/loading.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {
namespace {

const std::filesystem::path recorded = TRELLIS_CONFORMANCE_DIR;

/// The lines that <log> writes, each with its session.
class Logs final : public TraceSink {
public:
    void on(const TraceEvent& event) override {
        if (event.kind == TraceEvent::Kind::log) {
            lines.push_back({event.session, std::string(event.text)});
        }
    }
    struct Line {
        std::uint32_t session;
        std::string text;
    };
    std::vector<Line> lines;
};

struct Outcome {
    std::string end;  ///< a state, "-" if it does not end, or "rejected: …"
    std::vector<Logs::Line> logs = {};
    std::optional<Program> program = {};
};

Outcome outcome_of(const std::filesystem::path& path) {
    Diagnostics diagnostics;
    Disk disk;
    Outcome out;
    out.program =
        load({path.string(), read_file(path)}, script_registry(), diagnostics, {.reader = &disk});
    if (!out.program) {
        out.end = "rejected: " + diagnostics.render();
        return out;
    }
    ScriptRun run(*out.program);
    Logs logs;
    const StepOptions options{.dt = 1.0 / 60, .trace = &logs};
    for (int steps = 0; steps < 1000 && !run.state.session.final && !run.state.fault; ++steps) {
        const std::optional<std::uint64_t> idle = idle_cycles(*out.program, run.state);
        if (!idle) { break; }
        skip_cycles(run.state, *idle);
        run.step(options);
    }
    out.logs = std::move(logs.lines);
    out.end = run.state.fault           ? describe_fault(*out.program, run.state)
              : run.state.session.final ? std::string(out.program->name(run.state.session.final))
                                        : "-";
    return out;
}

/// What the manifest asks of one test.
class Check {
public:
    Check(const JsonTree& manifest, JsonId check) : m_(manifest), check_(check) {}

    /// What is wrong with an outcome; empty if nothing is.
    std::string fault_of(const Outcome& outcome) const {
        const bool rejected = outcome.end.starts_with("rejected");
        if (m_.member(check_, "load")) { return rejected ? "" : "was not rejected"; }
        if (m_.member(check_, "or_load") && rejected) { return ""; }
        if (outcome.end != m_.text(m_.member(check_, "final"))) { return "ended: " + outcome.end; }
        for (const std::string_view text : texts("log_contains")) {
            if (place(outcome, text) == none) { return "log lacks " + std::string(text); }
        }
        for (const std::string_view text : texts("log_excludes")) {
            if (place(outcome, text) != none) { return "log has " + std::string(text); }
        }
        std::size_t before = 0;
        for (const std::string_view text : texts("log_sequence")) {
            const std::size_t at = place(outcome, text);
            if (at == none || at < before) { return "log in another order"; }
            before = at;
        }
        const std::vector<std::string_view> same = texts("log_same_error_behaviour");
        if (same.size() == 2 &&
            (place(outcome, same[0]) == none) != (place(outcome, same[1]) == none)) {
            return "two errors are not alike";
        }
        return m_.member(check_, "log_halves_equal") ? fault_of_halves(outcome) : "";
    }

private:
    static constexpr std::size_t none = std::string::npos;

    std::vector<std::string_view> texts(std::string_view key) const {
        std::vector<std::string_view> out;
        const JsonId list = m_.member(check_, key);
        if (!list) { return out; }
        for (const JsonId text : m_.children(list)) {
            out.push_back(m_.text(text));
        }
        return out;
    }

    static std::size_t place(const Outcome& outcome, std::string_view text) {
        for (std::size_t i = 0; i < outcome.logs.size(); ++i) {
            if (outcome.logs[i].text.find(text) != none) { return i; }
        }
        return none;
    }

    /// Two sessions must have logged the same.
    static std::string fault_of_halves(const Outcome& outcome) {
        std::string halves[2];
        for (const Logs::Line& line : outcome.logs) {
            halves[line.session == outcome.logs[0].session ? 0 : 1] += line.text + '\n';
        }
        const auto lines = std::count(halves[0].begin(), halves[0].end(), '\n');
        return lines == 7 && halves[0] == halves[1] ? "" : "the sessions logged different things";
    }

    const JsonTree& m_;
    JsonId check_;
};

std::optional<JsonTree> json_file(const std::filesystem::path& path) {
    Diagnostics diagnostics;
    std::optional<JsonTree> json = parse_json(read_file(path), 0, diagnostics);
    REQUIRE(json.has_value());
    return json;
}

}  // namespace

TEST_CASE("machine cases: the W3C's tests do what their manifest says, in both spellings") {
    if (!std::filesystem::exists(recorded / "machines")) {
        MESSAGE("no recorded machines in " TRELLIS_CONFORMANCE_DIR);
        return;
    }
    const std::optional<JsonTree> manifest = json_file(recorded / "machines/manifest.json");
    const JsonTree& m = *manifest;
    std::size_t tests = 0;
    std::size_t passed = 0;
    for (const JsonId test : m.children(m.member(m.root(), "tests"))) {
        const Check check(m, m.member(test, "check"));
        std::filesystem::path path = recorded / "machines" / m.text(m.member(test, "file"));
        const Outcome xml = outcome_of(path.replace_extension(".scxml"));
        const Outcome json = outcome_of(path.replace_extension(".json"));
        const std::string name = path.stem().string();
        const std::string in_xml = check.fault_of(xml);
        const std::string in_json = check.fault_of(json);
        const bool twins = xml.program.has_value() == json.program.has_value() &&
                           (!xml.program || *xml.program == *json.program);
        ++tests;
        passed += in_xml.empty() && in_json.empty() && twins ? 1U : 0U;
        CAPTURE(name);
        CHECK(in_xml == "");
        CHECK(in_json == "");
        CHECK(twins);
    }
    MESSAGE(passed, " of ", tests, " tests of the W3C pass in both spellings");
}

TEST_CASE("machine cases: the recorded statecharts have the recorded configurations") {
    if (!std::filesystem::exists(recorded / "statecharts")) {
        MESSAGE("no recorded statecharts in " TRELLIS_CONFORMANCE_DIR);
        return;
    }
    const std::optional<JsonTree> expected = json_file(recorded / "statecharts/expected.json");
    const JsonTree& m = *expected;
    std::size_t charts = 0;
    std::size_t passed = 0;
    for (const JsonId chart : m.children(m.root())) {
        const std::string file(m.text(m.member(chart, "file")));
        const Program program = loaded(read_file(recorded / "statecharts" / file));
        ScriptRun run(program);
        run.start();
        std::string here = configuration(program, run.state) + '\n';
        for (const JsonId event : m.children(m.member(chart, "events"))) {
            if (!run.state.session.final && !run.state.fault) {
                send(program, run.state, m.text(event));
                run.step();
            }
            here += configuration(program, run.state) + '\n';
        }
        std::string there;
        for (const JsonId line : m.children(m.member(chart, "configurations"))) {
            there += std::string(m.text(line)) + '\n';
        }
        ++charts;
        passed += here == there ? 1U : 0U;
        CAPTURE(file);
        CHECK(here == there);
    }
    MESSAGE(passed, " of ", charts, " recorded statecharts have the recorded configurations");
}

}  // namespace trellis::test
