// Both runs in lockstep.
// SPDX-License-Identifier: MIT
#include "runner/comparison.h"

#include "exec/step.h"

#include <cmath>
#include <utility>

namespace trellis {

namespace {

bool leaves_differ(const Contestant& a, const Contestant& b) {
    const std::string_view left = a.episode().row().leaf;
    const std::string_view right = b.episode().row().leaf;
    return left != right && a.entrant().labels.find(right) && b.entrant().labels.find(left);
}

std::vector<std::string_view> differing_columns(const Contestant& a, const Contestant& b) {
    const Roomba& p = a.episode().robot();
    const Roomba& q = b.episode().robot();
    std::vector<std::string_view> columns;
    const auto add = [&](std::string_view name, bool differs) {
        if (differs) { columns.push_back(name); }
    };
    add("leaf", leaves_differ(a, b));
    add("x", p.x != q.x);
    add("y", p.y != q.y);
    add("rotation", p.rotation != q.rotation);
    add("v", p.v != q.v);
    add("w", p.w != q.w);
    add("bumper", p.bumper != q.bumper);
    add("ended", a.is_over() != b.is_over());
    return columns;
}

}  // namespace

std::string Match::fault() const {
    for (const Contestant* contestant : {&a, &b}) {
        const std::string text =
            describe_fault(contestant->entrant().program, contestant->episode().state());
        if (!text.empty()) { return text; }
    }
    return {};
}

Match compare(const Entrant& a, const Entrant& b, const EpisodeSetup& setup, std::uint64_t ticks,
              std::string random) {
    Match match{std::move(random), Contestant(a, setup), Contestant(b, setup)};
    for (std::uint64_t i = 0; i < ticks && !match.a.is_over() && !match.b.is_over(); ++i) {
        // both, whatever the first says
        const bool a_went_on = match.a.tick();
        const bool b_went_on = match.b.tick();
        if (!a_went_on || !b_went_on) { break; }
        if (!match.parting) {
            std::vector<std::string_view> columns = differing_columns(match.a, match.b);
            if (!columns.empty()) {
                match.parting.emplace(Parting{std::move(columns), match.a, match.b});
            }
        }
        const Roomba& p = match.a.episode().robot();
        const Roomba& q = match.b.episode().robot();
        const double distance = std::hypot(p.x - q.x, p.y - q.y);
        if (distance > match.distance) {
            match.distance = distance;
            match.distance_tick = match.a.episode().state().tick;
        }
    }
    return match;
}

}  // namespace trellis
