// The members of a line.
// SPDX-License-Identifier: MIT
#include "runner/event_lines.h"

#include "runner/json_writer.h"

namespace trellis {

void append_event_line(std::string& out, const Program& program, const TraceEvent& event) {
    using Kind = TraceEvent::Kind;
    if (event.kind == Kind::status || event.kind == Kind::event) { return; }
    JsonWriter json(JsonWriter::Layout::one_line);
    json.begin_object().count("tick", event.tick).text("event", name_of(event.kind));
    if (event.row) { json.count("row", event.row.index).text("name", program.name(event.row)); }
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

}  // namespace trellis
