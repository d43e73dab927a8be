// What three behaviours do in 40 s with one seed, recorded event by event as JSON Lines: states
// entered and left, transitions, leaves halted, and the ticks in which a leaf ends. Compared as
// text; script/update-goldens records anew. Poses are in traces_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/trace.h"
#include "runner/event_lines.h"
#include "sim/bridge/episode.h"
#include "sim/bridge/leaves.h"
#include "support/behaviours.h"
#include "support/files.h"
#include "support/goldens.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

using namespace trellis;
using namespace trellis::test;

namespace {

constexpr int ticks = 2'400;
constexpr std::int64_t seed = 7;  // of random.Random

/// Keeps the lines of all events but the ticks in which a leaf runs on.
class Lines final : public TraceSink {
public:
    explicit Lines(const Program& program) : program_(program) {}

    void on(const TraceEvent& event) override {
        if (event.kind == TraceEvent::Kind::tick && event.to == Status::running) return;
        append_event_line(text, program_, event);
    }

    std::string text;

private:
    const Program& program_;
};

std::string events_of(const Program& program) {
    Episode run(program, {.world = {}, .dt = lab_dt, .random = Random(seed)});
    Lines lines(program);
    for (int tick = 0; tick < ticks; ++tick) {
        const bool went_on = run.tick(&lines);
        REQUIRE_MESSAGE(went_on, run.state().fault.message);
    }
    return lines.text;
}

}  // namespace

TEST_CASE("event goldens: machines and a tree do in order what was recorded") {
    Registry registry;
    register_roomba(registry);
    for (const std::string_view file :
         {"machines/roomba.scxml", "machines/roomba_leaves.scxml", "trees/roomba.xml"}) {
        CAPTURE(file);
        const std::string ours = events_of(program_of(file, registry));
        const auto name = ("events" / std::filesystem::path(file)).replace_extension(".jsonl");
        const auto recorded = golden(name, ours);
        if (!recorded) continue;
        const auto a = lines_of(ours), b = lines_of(*recorded);
        for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
            REQUIRE(a[i] == b[i]);
        CHECK(a.size() == b.size());
    }
}
