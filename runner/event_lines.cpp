// The members of a line.
// SPDX-License-Identifier: MIT
#include "runner/event_lines.h"

#include "runner/json_writer.h"

namespace trellis {

void append_run_line(std::string& out, const Program& program, const RunLine& run) {
    JsonWriter json(JsonWriter::Layout::one_line);
    json.begin_object().count("tick", 0).text("event", "run").count("row", 0);
    json.text("name", program.name({0})).text("file", run.file);
    if (!run.tree.empty()) { json.text("tree", run.tree); }
    json.count("rows", program.rows.size()).number("dt", run.dt).text("random", run.random);
    out += std::move(json.end_object()).finish();
}

void append_event_line(std::string& out, const Program& outermost, const TraceEvent& event) {
    using Kind = TraceEvent::Kind;
    const Program& program = event.machine != nullptr ? *event.machine : outermost;
    const bool is_state = event.row && op_table()[program.at(event.row).op].group == OpGroup::state;
    if ((event.kind == Kind::status && is_state) || event.kind == Kind::event) { return; }
    JsonWriter json(JsonWriter::Layout::one_line);
    json.begin_object().count("tick", event.tick).text("event", name_of(event.kind));
    if (event.machine != nullptr) { json.count("session", event.session); }
    if (event.row) { json.count("row", event.row.index).text("name", program.name(event.row)); }
    if (event.kind == Kind::status) {
        json.text("from", name_of(event.from)).text("to", name_of(event.to));
    }
    if (event.kind == Kind::tick) { json.text("status", name_of(event.to)); }
    if (event.kind == Kind::transition) {
        const Transition& transition = program.transitions[event.transition.index];
        json.count("index", event.transition.index).begin_array("to");
        for (std::uint32_t i = 0; i < transition.target_count; ++i) {
            json.element(program.name(program.targets[transition.first_target + i]));
        }
        json.end_array();
    }
    if (!event.text.empty()) { json.text("text", event.text); }
    out += std::move(json.end_object()).finish();
}

void append_end_line(std::string& out, std::uint64_t tick, std::string_view ended) {
    JsonWriter json(JsonWriter::Layout::one_line);
    json.begin_object().count("tick", tick).text("event", "end").text("text", ended);
    out += std::move(json.end_object()).finish();
}

}  // namespace trellis
