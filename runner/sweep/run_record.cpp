// Fields between blanks; the message, which may have blanks, is the last before the checksum.
// SPDX-License-Identifier: MIT
#include "runner/sweep/run_record.h"

#include "core/number.h"

#include <algorithm>

namespace trellis {
namespace {

constexpr std::string_view none = "-";

/// FNV-1a.
std::uint64_t checksum(std::string_view text) {
    std::uint64_t sum = 0xCBF29CE484222325;
    for (const char c : text)
        sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001B3;
    return sum;
}

/// Takes fields off the front of a line.
class Fields {
public:
    explicit Fields(std::string_view line) : rest_(line) {}

    bool ok() const { return ok_; }
    std::string_view rest() const { return rest_; }

    std::string_view word() {
        const std::size_t end = std::min(rest_.find(' '), rest_.size());
        const std::string_view field = rest_.substr(0, end);
        ok_ = ok_ && !field.empty();
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return field;
    }
    double number() {
        const ParsedNumber parsed = parse_whole_number(word());
        ok_ = ok_ && parsed.length != 0;
        return parsed.value;
    }
    std::uint64_t count() {
        const double value = number();
        ok_ = ok_ && value >= 0.0 && value < 9e15;
        return ok_ ? static_cast<std::uint64_t>(value) : 0;
    }

private:
    std::string_view rest_;
    bool ok_ = true;
};

std::optional<Ending> ending_of(std::string_view word) {
    for (const Ending ending : endings) {
        if (name_of(ending) == word) return ending;
    }
    return {};
}

bool read_stop(Fields& in, Measures& stop) {
    stop.covered = in.count();
    stop.largest_gap = in.count();
    stop.driven.distance = in.number();
    stop.driven.turns = in.count();
    stop.driven.bumps = in.count();
    stop.dirt = in.number();
    const std::optional<Ending> ending = ending_of(in.word());
    stop.ended = in.count();
    stop.ending = ending.value_or(Ending::time);
    return ending.has_value();
}

}  // namespace

std::string record_of(std::uint64_t number, const MeasuredRun& run) {
    std::string line = std::to_string(number);
    const auto field = [&](const std::string& text) { (line += ' ') += text; };
    for (const Measures& stop : run.stops) {
        field(std::to_string(stop.covered));
        field(std::to_string(stop.largest_gap));
        field(print_number(stop.driven.distance));
        field(std::to_string(stop.driven.turns));
        field(std::to_string(stop.driven.bumps));
        field(print_number(stop.dirt));
        field(std::string(name_of(stop.ending)));
        field(std::to_string(stop.ended));
    }
    for (const std::uint64_t cells : run.curve)
        field(std::to_string(cells));
    for (const std::optional<std::uint64_t>& tick : run.reached)
        field(tick ? std::to_string(*tick) : std::string(none));
    // one line, whatever the message holds
    std::string message = run.message;
    std::replace(message.begin(), message.end(), '\n', '\v');
    field(message);
    return line + ' ' + std::to_string(checksum(line)) + '\n';
}

std::optional<NumberedRun> read_record(std::string_view line, const Measuring& measuring) {
    const std::size_t last = line.rfind(' ');
    if (last == std::string_view::npos) return {};
    if (line.substr(last + 1) != std::to_string(checksum(line.substr(0, last)))) return {};
    Fields in(line.substr(0, last));
    NumberedRun read;
    auto& [number, run] = read;
    number = in.count();
    for (const std::uint64_t tick : measuring.stops) {
        Measures& stop = run.stops.emplace_back();
        stop.tick = tick;
        if (!read_stop(in, stop)) return {};
    }
    for (std::size_t i = 0; i < measuring.curve.size(); ++i)
        run.curve.push_back(in.count());
    for (std::optional<std::uint64_t>& tick : run.reached) {
        Fields field(in.word());
        if (field.rest() != none) tick = field.count();
    }
    run.message = in.rest();
    std::replace(run.message.begin(), run.message.end(), '\v', '\n');
    if (!in.ok()) return {};
    return read;
}

}  // namespace trellis
