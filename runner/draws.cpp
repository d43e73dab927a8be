// A line at a time.
// SPDX-License-Identifier: MIT
#include "runner/draws.h"

#include "core/number.h"
#include "load/text.h"

#include <cmath>
#include <cstdint>

namespace trellis {

std::vector<double> read_draws(const std::string& name, std::string_view text,
                               Diagnostics& diagnostics) {
    const std::uint32_t file = diagnostics.add_file(name, text);
    std::vector<double> draws;
    for (std::uint32_t line = 1; !text.empty(); ++line) {
        const std::string_view whole = text.substr(0, text.find('\n'));
        text.remove_prefix(whole.size() == text.size() ? whole.size() : whole.size() + 1);
        const std::string_view number = trimmed(whole.substr(0, whole.find('#')));
        if (number.empty()) { continue; }
        const ParsedNumber parsed = parse_whole_number(number);
        if (parsed.length != 0 && std::isfinite(parsed.value)) {
            draws.push_back(parsed.value);
            continue;
        }
        const auto column = static_cast<std::uint32_t>(number.data() - whole.data() + 1);
        diagnostics.error("bad-number", {file, line, column},
                          "expected a number, found " + quoted(number));
    }
    return draws;
}

}  // namespace trellis
