// Spelling the fields of a row.
// SPDX-License-Identifier: MIT
#include "sim/bridge/trace_csv.h"

#include "core/number.h"

namespace trellis {

namespace {

void append_field(std::string& out, std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        out += text;
        return;
    }
    out += '"';
    for (const char c : text) {
        if (c == '"') { out += '"'; }
        out += c;
    }
    out += '"';
}

}  // namespace

void append_trace_csv(std::string& out, const EpisodeRow& row) {
    const Roomba& robot = row.robot;
    out += std::to_string(row.tick);
    for (const double number : {row.time, robot.x, robot.y, robot.rotation, robot.v, robot.w}) {
        out += ',';
        append_number(out, number);
    }
    out += robot.bumper ? ",1," : ",0,";
    append_field(out, row.leaf);
    out += '\n';
}

}  // namespace trellis
