// The members of a line.
// SPDX-License-Identifier: MIT
#include "runner/event_lines.h"

#include "runner/json_writer.h"

namespace trellis {

std::string_view event_word(TraceEvent::Kind kind) {
    switch (kind) {
    case TraceEvent::Kind::tick: return "tick";
    case TraceEvent::Kind::halt: return "halt";
    case TraceEvent::Kind::enter: return "enter";
    case TraceEvent::Kind::leave: return "leave";
    case TraceEvent::Kind::transition: return "transition";
    case TraceEvent::Kind::log: return "log";
    case TraceEvent::Kind::error: return "error";
    case TraceEvent::Kind::status:
    case TraceEvent::Kind::event: break;
    }
    return {};
}

void append_event_line(std::string& out, const Program& program, const TraceEvent& event) {
    const std::string_view word = event_word(event.kind);
    if (word.empty()) { return; }
    JsonWriter json(JsonWriter::Layout::one_line);
    json.begin_object().count("tick", event.tick).text("event", word);
    if (event.row) { json.count("row", event.row.index).text("name", program.name(event.row)); }
    if (event.kind == TraceEvent::Kind::tick) { json.text("status", name_of(event.to)); }
    if (event.kind == TraceEvent::Kind::transition) {
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
