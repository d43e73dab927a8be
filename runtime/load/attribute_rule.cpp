// Decides which values an attribute takes, and says it: to people, and as a regular expression.
// Covered by tests/load/grammar_test.cpp, and against independent validators by
// tests/load/faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/attribute_rule.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace trellis {

namespace {

constexpr std::string_view booleans[] = {"0",    "1",     "true", "false",
                                         "True", "False", "TRUE", "FALSE"};
constexpr std::string_view blanks = " \t\n\r";

/// Removes digits from the front; returns whether there was one.
bool skip_digits(std::string_view& text) {
    const std::size_t before = text.size();
    while (!text.empty() && text.front() >= '0' && text.front() <= '9') {
        text.remove_prefix(1);
    }
    return text.size() != before;
}

void skip_sign(std::string_view& text) {
    if (text.starts_with('-') || text.starts_with('+')) { text.remove_prefix(1); }
}

bool is_integer(std::string_view text) {
    if (text.starts_with('-')) { text.remove_prefix(1); }
    return skip_digits(text) && text.empty();
}

bool is_number(std::string_view text) {
    skip_sign(text);
    bool digits = skip_digits(text);
    if (text.starts_with('.')) {
        text.remove_prefix(1);
        digits = skip_digits(text) || digits;
    }
    if (!digits) { return false; }
    if (text.starts_with('e') || text.starts_with('E')) {
        text.remove_prefix(1);
        skip_sign(text);
        if (!skip_digits(text)) { return false; }
    }
    return text.empty();
}

template <class List>
bool contains(const List& list, std::string_view word) {
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

template <class T>
bool fits(std::string_view digits) {
    T value{};
    return std::from_chars(digits.data(), digits.data() + digits.size(), value).ec == std::errc{};
}

/// The words as alternatives of a regular expression. They are letters, digits, '_' and '.'.
template <class List>
std::string alternatives(const List& list) {
    std::string out;
    for (const std::string_view word : list) {
        if (!out.empty()) { out += '|'; }
        for (const char c : word) {
            if (c == '.') { out += '\\'; }
            out += c;
        }
    }
    return out;
}

/// "a", "a or b", "a, b or c".
std::string listed(const std::vector<std::string>& words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) { out += i + 1 == words.size() ? " or " : ", "; }
        out += words[i];
    }
    return out;
}

/// What values of a type are called.
std::string_view noun(ValueType type) {
    switch (type) {
    case ValueType::text: return "a text";
    case ValueType::int32:
    case ValueType::int64: return "an integer";
    case ValueType::count: return "an integer from 0";
    case ValueType::number: return "a number";
    case ValueType::key: return "a {key}";
    case ValueType::name: return "a name without blanks";
    case ValueType::names: return "names with blanks between them";
    case ValueType::script: return "a script";
    case ValueType::expression: return "an expression";
    case ValueType::boolean:
    case ValueType::choice: break;  // their values are listed
    }
    return {};
}

/// The pattern of a literal; empty: everything.
std::string literal_pattern(const AttributeRule& rule) {
    switch (rule.type) {
    case ValueType::text:
    case ValueType::script:
    case ValueType::expression: return {};
    case ValueType::int32:
    case ValueType::int64:
        return rule.choices.empty() ? "-?[0-9]+" : "-?[0-9]+|" + alternatives(rule.choices);
    case ValueType::count: return "[0-9]+";
    case ValueType::number: return "[+\\-]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][+\\-]?[0-9]+)?";
    case ValueType::boolean: return alternatives(booleans);
    case ValueType::key: return " *\\{[^{}]+\\} *";
    case ValueType::name: return "[^ \\t\\n\\r]+";
    case ValueType::names: return "[ \\t\\n\\r]*[^ \\t\\n\\r][\\s\\S]*";
    case ValueType::choice: return alternatives(rule.choices);
    }
    return {};
}

}  // namespace

bool is_pointer(std::string_view value) {
    while (value.starts_with(' ')) {
        value.remove_prefix(1);
    }
    while (value.ends_with(' ')) {
        value.remove_suffix(1);
    }
    if (value.size() < 3 || !value.starts_with('{') || !value.ends_with('}')) { return false; }
    value = value.substr(1, value.size() - 2);
    return value.find_first_of("{}") == std::string_view::npos;
}

bool accepts(const AttributeRule& rule, std::string_view value) {
    if (rule.may_be_pointer && is_pointer(value)) { return true; }
    switch (rule.type) {
    case ValueType::text:
    case ValueType::script:
    case ValueType::expression: return true;
    case ValueType::int32:
    case ValueType::int64: return is_integer(value) || contains(rule.choices, value);
    case ValueType::count: return is_integer(value) && !value.starts_with('-');
    case ValueType::number: return is_number(value);
    case ValueType::boolean: return contains(booleans, value);
    case ValueType::key: return is_pointer(value);
    case ValueType::name:
        return !value.empty() && value.find_first_of(blanks) == std::string_view::npos;
    case ValueType::names: return value.find_first_not_of(blanks) != std::string_view::npos;
    case ValueType::choice: return contains(rule.choices, value);
    }
    return false;
}

bool in_range(const AttributeRule& rule, std::string_view value) {
    const bool whole = rule.type == ValueType::int32 || rule.type == ValueType::int64 ||
                       rule.type == ValueType::count;
    if (!whole || !is_integer(value)) { return true; }
    if (rule.type == ValueType::int32) { return fits<std::int32_t>(value); }
    return rule.type == ValueType::count ? fits<std::uint32_t>(value) : fits<std::int64_t>(value);
}

std::string expectation(const AttributeRule& rule) {
    std::vector<std::string> words;
    if (rule.type == ValueType::choice) {
        words = rule.choices;
    } else if (rule.type == ValueType::boolean) {
        words = {"true", "false"};
    } else {
        words.emplace_back(noun(rule.type));
    }
    if (!rule.unit.empty() && rule.type != ValueType::key) { words.back() += " in " + rule.unit; }
    if (rule.may_be_pointer && rule.type != ValueType::key) { words.emplace_back("a {key}"); }
    return listed(words);
}

std::string pattern(const AttributeRule& rule) {
    std::string out = literal_pattern(rule);
    if (!out.empty() && rule.may_be_pointer && rule.type != ValueType::key) {
        out += "| *\\{[^{}]+\\} *";
    }
    return out;
}

}  // namespace trellis
