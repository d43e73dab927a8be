// Damaging, loading and running texts.
// SPDX-License-Identifier: MIT
#include "support/survival.h"

#include "core/state.h"
#include "exec/step.h"
#include "load/load.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace trellis::test {

namespace {

constexpr std::array tokens = {std::string_view("<"),
                               std::string_view(">"),
                               std::string_view("/>"),
                               std::string_view("\""),
                               std::string_view("{"),
                               std::string_view("}"),
                               std::string_view("["),
                               std::string_view(","),
                               std::string_view("&lt;"),
                               std::string_view("&#0;"),
                               std::string_view("<!--"),
                               std::string_view("-->"),
                               std::string_view("<![CDATA["),
                               std::string_view("]]>"),
                               std::string_view("<?xml ?>"),
                               std::string_view("null"),
                               std::string_view("-1"),
                               std::string_view("99999999999999999999"),
                               std::string_view("1e999"),
                               std::string_view("''"),
                               std::string_view("Sequence"),
                               std::string_view("ReactiveFallback"),
                               std::string_view("Repeat"),
                               std::string_view("RetryUntilSuccessful"),
                               std::string_view("Inverter"),
                               std::string_view("SubTree"),
                               std::string_view("Script"),
                               std::string_view("ScriptCondition"),
                               std::string_view("num_cycles"),
                               std::string_view("code"),
                               std::string_view("ID"),
                               std::string_view("_skipIf"),
                               std::string_view("_autoremap"),
                               std::string_view("state"),
                               std::string_view("final"),
                               std::string_view("transition"),
                               std::string_view("initial"),
                               std::string_view("onentry"),
                               std::string_view("invoke"),
                               std::string_view("raise"),
                               std::string_view("assign"),
                               std::string_view("target"),
                               std::string_view("event"),
                               std::string_view("cond"),
                               std::string_view("elapsed()"),
                               std::string_view("In('a')"),
                               std::string_view("_event.data"),
                               std::string_view(":= "),
                               std::string_view("&amp;&amp;"),
                               std::string_view("? :"),
                               std::string_view("((("),
                               std::string_view("\xC3"),
                               std::string_view("\xF4\x90\x80\x80"),
                               std::string_view("\0", 1)};

std::size_t below(Random& random, std::size_t n) {
    return static_cast<std::size_t>(random.whole(0, static_cast<std::int64_t>(n) - 1));
}

/// Where a word that is a token begins, searched from a random place; npos if there is none.
std::size_t find_token(std::string_view text, std::string_view token, Random& random) {
    const std::size_t found = text.find(token, below(random, text.size()));
    return found != std::string_view::npos ? found : text.find(token);
}

void damage(std::string& text, Random& random) {
    const std::size_t at = below(random, text.size());
    const std::size_t size = std::min(text.size() - at, below(random, 40) + 1);
    const std::string_view token = tokens[below(random, tokens.size())];
    switch (random.whole(0, 7)) {
    case 0: text[at] = static_cast<char>(random.whole(0, 255)); break;
    case 1:
        text[at] =
            static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << below(random, 8)));
        break;
    case 2: text.erase(at, size); break;
    case 3: text.insert(at, token); break;
    case 4: text.insert(below(random, text.size()), text.substr(at, size * 4)); break;
    case 5: text.resize(at); break;
    default: {
        const std::string_view other = tokens[below(random, tokens.size())];
        const std::size_t found = find_token(text, other, random);
        if (found != std::string::npos) { text.replace(found, other.size(), token); }
        break;
    }
    }
}

}  // namespace

std::string damaged(std::string text, Random& random) {
    for (std::int64_t n = random.whole(1, 3); n > 0 && !text.empty(); --n) {
        damage(text, random);
    }
    return text;
}

void survive(std::string_view text, const Registry& registry, HostRef host, Survival& survival) {
    ++survival.texts;
    Diagnostics diagnostics;
    const std::optional<Program> program =
        load({.name = "damaged", .text = std::string(text)}, registry, diagnostics,
             {.limits = {.bytes = 1 << 20, .depth = 64, .elements = 10'000}, .rows = 10'000});
    if (!program) {
        static_cast<void>(diagnostics.render());
        return;
    }
    ++survival.loaded;
    State state = fresh_state(*program);
    state.random = Random(std::int64_t{1});
    const StepOptions options{.budget = 1000};
    start(*program, state, host, options);
    for (int tick = 0; tick < 50 && !state.fault; ++tick) {
        step(*program, state, host, options);
        if (tick != 20) { continue; }
        const std::vector<std::byte> bytes = save(*program, state);
        state = restore(*program, bytes).value();
    }
    if (state.fault) {
        ++survival.faults;
        static_cast<void>(describe_fault(*program, state));
        return;
    }
    halt(*program, state, host, options);
}

}  // namespace trellis::test
