// Ordering and numbering of event names.
// SPDX-License-Identifier: MIT
#include "load/event_names.h"

#include <algorithm>

namespace trellis {

bool EventNames::ByToken::operator()(std::string_view a, std::string_view b) const {
    return token_less(a, b);
}

std::string_view EventNames::bare(std::string_view name) {
    if (name.ends_with('*')) { name.remove_suffix(1); }
    while (name.ends_with('.')) {
        name.remove_suffix(1);
    }
    return name;
}

void EventNames::add(std::string_view name) {
    names_.emplace(bare(name));
}

std::vector<EventName> EventNames::table() const {
    std::vector<EventName> rows = {{.text = {}, .end = {}}};
    std::vector<std::uint32_t> open = {0};  // the rows that the next name may be inside of
    const auto close_until = [&](std::string_view name) {
        while (open.size() > 1) {
            const std::string& prefix = rows[open.back()].text;
            if (name.size() > prefix.size() && name.starts_with(prefix) &&
                name[prefix.size()] == '.') {
                return;
            }
            rows[open.back()].end = {static_cast<std::uint32_t>(rows.size())};
            open.pop_back();
        }
    };
    for (const std::string& name : names_) {
        if (name.empty()) { continue; }
        close_until(name);
        open.push_back(static_cast<std::uint32_t>(rows.size()));
        rows.push_back({.text = name, .end = {}});
    }
    close_until({});
    rows[0].end = {static_cast<std::uint32_t>(rows.size())};
    return rows;
}

EventId EventNames::find(const std::vector<EventName>& table, std::string_view name) {
    name = bare(name);
    if (name.empty()) { return {0}; }
    const auto found = std::lower_bound(
        table.begin() + 1, table.end(), name,
        [](const EventName& row, std::string_view wanted) { return ByToken()(row.text, wanted); });
    if (found == table.end() || found->text != name) { return {}; }
    return {static_cast<std::uint32_t>(found - table.begin())};
}

}  // namespace trellis
