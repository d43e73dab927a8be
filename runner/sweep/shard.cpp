// From words to parts.
// SPDX-License-Identifier: MIT
#include "runner/sweep/shard.h"

#include <charconv>

namespace trellis {
namespace {

std::optional<std::uint64_t> whole(std::string_view text) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return {};
    return value;
}

std::optional<Shard> shard(std::optional<std::uint64_t> number,
                           std::optional<std::uint64_t> count) {
    if (!number || !count || *number < 1 || *number > *count) return {};
    return Shard{*number, *count};
}

}  // namespace

std::optional<Shard> parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return {};
    return shard(whole(text.substr(0, slash)), whole(text.substr(slash + 1)));
}

std::optional<Shard> slurm_shard(const char* (*environment)(const char*)) {
    const auto value = [&](const char* name) -> std::string_view {
        const char* text = environment == nullptr ? nullptr : environment(name);
        return text == nullptr ? std::string_view() : text;
    };
    const std::string_view id = value("SLURM_ARRAY_TASK_ID");
    const std::string_view count = value("SLURM_ARRAY_TASK_COUNT");
    if (id.empty() || count.empty()) return Shard{};
    // arrays need not begin with 1, nor count by ones
    const std::uint64_t least = whole(value("SLURM_ARRAY_TASK_MIN")).value_or(1);
    const std::uint64_t step = whole(value("SLURM_ARRAY_TASK_STEP")).value_or(1);
    const std::optional<std::uint64_t> number = whole(id);
    if (!number || *number < least || step == 0 || (*number - least) % step != 0) return {};
    return shard((*number - least) / step + 1, whole(count));
}

std::string journal_name(const std::string& out, const Shard& part) {
    if (part.is_whole()) return out + ".runs";
    return out + '.' + std::to_string(part.number) + "-of-" + std::to_string(part.count) + ".runs";
}

}  // namespace trellis
