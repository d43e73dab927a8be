// Tables, and the same as JSON.
// SPDX-License-Identifier: MIT
#include "runner/profile_report.h"

#include "runner/places.h"
#include "runner/table.h"

#include <string_view>
#include <vector>

namespace trellis {

namespace {

bool is_state(const Program& program, RowId n) {
    return op_table()[program.at(n).op].group == OpGroup::state;
}

double share(const ProfileReport& report, std::uint64_t ticks) {
    return report.ticks == 0 ? 0.0 : static_cast<double>(ticks) / static_cast<double>(report.ticks);
}

double seconds(const ProfileReport& report, std::uint64_t ticks) {
    return static_cast<double>(ticks) * report.dt;
}

/// Depth below row 0, two blanks each.
std::string indent(const Program& program, RowId n) {
    std::string blanks;
    for (RowId up = program.at(n).parent; up; up = program.at(up).parent) {
        blanks += "  ";
    }
    return blanks;
}

/// "file:line:column".
std::string place_of(const Program& program, RowId n) {
    const Origin& origin = program.origins[n.index];
    if (origin.line == 0) { return {}; }
    return program.files[origin.file] + ':' + std::to_string(origin.line) + ':' +
           std::to_string(origin.column);
}

/// The rows that have numbers of their own: nodes of trees, states, what states run.
std::vector<RowId> rows_of(const Program& program) {
    std::vector<RowId> rows;
    for (RowId n{program.is_machine() ? 1U : 0U}; n.index < program.rows.size(); ++n.index) {
        if (program.at(n).op != Op::invoke) { rows.push_back(n); }
    }
    return rows;
}

/// The transitions that a document wrote as <transition>, in the order of the program.
std::vector<TransitionId> transitions_of(const Program& program) {
    std::vector<TransitionId> all;
    for (RowId n{0}; n.index < program.rows.size(); ++n.index) {
        if (!is_state(program, n)) { continue; }
        const StateInfo& state = program.state(n);
        for (std::uint32_t i = 0; i < state.transition_count; ++i) {
            all.push_back({state.first_transition + i});
        }
    }
    return all;
}

/// "MoveForward → MoveInSpiral  tick [elapsed() > 3]".
std::string words_of(const ProfileReport& report, const Places& places, TransitionId id) {
    const Program& program = report.program;
    const Transition& transition = program.transitions[id.index];
    std::string out(program.name(transition.source));
    for (std::uint32_t i = 0; i < transition.target_count; ++i) {
        out += i == 0 ? " → " : ", ";
        out += program.name(program.targets[transition.first_target + i]);
    }
    const ElementId e = places.of(id);
    if (!e) { return out; }
    const std::string_view event = report.document.value(e, "event");
    const std::string_view guard = report.document.value(e, "cond");
    if (!event.empty()) { out += "  " + std::string(event); }
    if (!guard.empty()) { out += (event.empty() ? "  [" : " [") + std::string(guard) + ']'; }
    return out;
}

std::string node_table(const ProfileReport& report) {
    std::vector<std::vector<std::string>> table{
        {"node", "ticks", "success", "failure", "skipped", "halted", "time", "share"}};
    for (const RowId n : rows_of(report.program)) {
        const Profile::Row& row = report.profile.row(n);
        table.push_back({indent(report.program, n) + std::string(report.program.name(n)),
                         std::to_string(row.ticks), std::to_string(row.successes),
                         std::to_string(row.failures), std::to_string(row.skips),
                         std::to_string(row.halts), fixed(seconds(report, row.ticks), 3) + " s",
                         fixed(100.0 * share(report, row.ticks), 1) + " %"});
    }
    return aligned(table);
}

std::string state_table(const ProfileReport& report) {
    std::vector<std::vector<std::string>> table{{"state", "entered", "ticks", "time", "share"}};
    for (const RowId n : rows_of(report.program)) {
        if (!is_state(report.program, n)) { continue; }
        const Profile::Row& row = report.profile.row(n);
        table.push_back({indent(report.program, n).substr(2) + std::string(report.program.name(n)),
                         std::to_string(row.entered), std::to_string(row.ticks),
                         fixed(seconds(report, row.ticks), 3) + " s",
                         fixed(100.0 * share(report, row.ticks), 1) + " %"});
    }
    return aligned(table);
}

std::string transition_table(const ProfileReport& report) {
    const Places places(report.program, report.document);
    std::vector<std::vector<std::string>> table{{"transition", "taken"}};
    for (const TransitionId id : transitions_of(report.program)) {
        table.push_back({words_of(report, places, id), std::to_string(report.profile.taken(id))});
    }
    return table.size() == 1 ? std::string() : '\n' + aligned(table);
}

std::string unreached(const ProfileReport& report) {
    std::vector<std::vector<std::string>> table;
    std::size_t count = 0;
    for (const RowId n : rows_of(report.program)) {
        ++count;
        if (report.profile.reached(n)) { continue; }
        table.push_back(
            {"  " + std::string(report.program.name(n)) + "  " + place_of(report.program, n)});
    }
    const bool machine = report.program.is_machine();
    const std::string all = std::to_string(count) + (machine ? " states and activities" : " nodes");
    if (table.empty()) { return "\nall " + all + " were reached\n"; }
    return "\nnever reached, of " + all + ":\n" + aligned(table);
}

}  // namespace

std::string_view kind_of(const Program& program, RowId n) {
    const Op op = program.at(n).op;
    if (op == Op::action || op == Op::condition) { return program.call(n).type->name; }
    return op == Op::tree ? std::string_view("BehaviorTree") : op_table()[op].element;
}

std::string profile_text(const ProfileReport& report) {
    const std::string table = report.program.is_machine()
                                  ? state_table(report) + transition_table(report)
                                  : node_table(report);
    return table + unreached(report);
}

void add_profile(JsonWriter& json, const ProfileReport& report) {
    const Program& program = report.program;
    json.begin_object("stats").begin_array("rows");
    for (const RowId n : rows_of(program)) {
        const Profile::Row& row = report.profile.row(n);
        json.begin_object().count("row", n.index);
        const RowId parent = program.at(n).parent;
        parent ? json.count("parent", parent.index) : json.null("parent");
        json.text("name", program.name(n)).text("kind", kind_of(program, n));
        json.text("place", place_of(program, n)).boolean("reached", report.profile.reached(n));
        json.count("entered", row.entered).count("ticks", row.ticks);
        if (!is_state(program, n)) {
            json.count("successes", row.successes).count("failures", row.failures);
            json.count("skips", row.skips).count("halts", row.halts);
        }
        json.number("time", seconds(report, row.ticks)).number("share", share(report, row.ticks));
        json.end_object();
    }
    json.end_array();
    if (program.is_machine()) {
        const Places places(program, report.document);
        json.begin_array("transitions");
        for (const TransitionId id : transitions_of(program)) {
            const Transition& transition = program.transitions[id.index];
            json.begin_object().count("index", id.index).count("row", transition.source.index);
            json.text("words", words_of(report, places, id));
            json.count("taken", report.profile.taken(id)).end_object();
        }
        json.end_array();
    }
    json.end_object();
}

}  // namespace trellis
