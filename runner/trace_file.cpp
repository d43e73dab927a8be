// Splitting lines into fields.
// SPDX-License-Identifier: MIT
#include "runner/trace_file.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace trellis {

namespace {

/// One field from the start of `rest`, which then begins with what ended it: a comma, a line end or
/// nothing. False if its quote is not closed.
bool take_field(std::string_view& rest, std::string& field) {
    field.clear();
    if (!rest.starts_with('"')) {
        const std::size_t end = std::min(rest.find_first_of(",\r\n"), rest.size());
        field = rest.substr(0, end);
        rest.remove_prefix(end);
        return true;
    }
    rest.remove_prefix(1);
    for (;;) {
        const std::size_t quote = rest.find('"');
        if (quote == std::string_view::npos) { return false; }
        field += rest.substr(0, quote);
        rest.remove_prefix(quote + 1);
        if (!rest.starts_with('"')) { return true; }
        field += '"';
        rest.remove_prefix(1);
    }
}

/// One row from the start of `rest`, with its line end. False if a quote is not closed or something
/// stands behind one.
bool take_row(std::string_view& rest, std::vector<std::string>& row) {
    row.clear();
    for (;;) {
        if (!take_field(rest, row.emplace_back())) { return false; }
        if (!rest.starts_with(',')) { break; }
        rest.remove_prefix(1);
    }
    if (rest.starts_with('\r')) { rest.remove_prefix(1); }
    if (rest.empty()) { return true; }
    if (!rest.starts_with('\n')) { return false; }
    rest.remove_prefix(1);
    return true;
}

}  // namespace

std::optional<TraceTable> read_trace(const std::string& name, std::string_view text,
                                     Diagnostics& diagnostics) {
    const std::uint32_t file = diagnostics.add_file(name, text);
    TraceTable table;
    std::vector<std::string> row;
    for (std::uint32_t line = 1; !text.empty();) {
        const std::string_view begin = text;
        if (!take_row(text, row)) {
            diagnostics.error("bad-trace", {file, line, 1}, "this row has a wrong quote");
            return {};
        }
        std::string_view whole = begin.substr(0, begin.size() - text.size());
        const auto line_ends = std::count(whole.begin(), whole.end(), '\n');
        whole = whole.substr(0, whole.find_last_not_of("\r\n") + 1);
        if (table.columns.empty()) {
            table.columns = row;
        } else if (row.size() == table.columns.size()) {
            table.rows.push_back(row);
            table.lines.push_back(whole);
        } else {
            diagnostics.error("bad-trace", {file, line, 1},
                              "expected " + std::to_string(table.columns.size()) +
                                  " fields, found " + std::to_string(row.size()));
        }
        line += static_cast<std::uint32_t>(line_ends);
    }
    const auto& columns = table.columns;
    if (std::find(columns.begin(), columns.end(), "tick") == columns.end()) {
        diagnostics.error("bad-trace", {file, 1, 1}, "expected a trace with a column \"tick\"");
    }
    if (!diagnostics.ok()) { return {}; }
    return table;
}

}  // namespace trellis
