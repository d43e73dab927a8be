// An option that takes one of a few words. For the commands' sources only: it includes CLI11.
// Covered by tests/runner/command_line_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

/// Adds the option `name`, which sets `target` to what stands beside the word given. Another word
/// is refused with the list of words, and a suggestion.
template <class Choice>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Choice& target,
                        std::vector<std::pair<std::string, Choice>> words, const std::string& doc) {
    std::string list;
    for (const auto& word : words) {
        list += (list.empty() ? "" : "|") + word.first;
    }
    const auto set = [name, &target, words = std::move(words), list](const std::string& given) {
        std::vector<std::string_view> known;
        for (const auto& [word, choice] : words) {
            if (word == given) {
                target = choice;
                return;
            }
            known.emplace_back(word);
        }
        throw CLI::ValidationError(name, "expected " + list + ", found \"" + given + '"' +
                                             suggestion(given, known));
    };
    return app.add_option_function<std::string>(name, set, doc)->type_name(list);
}

}  // namespace trellis
