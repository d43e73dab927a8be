// What one attribute of an element, or port of a node, takes: its type, its default, whether it
// must be given. Which elements have which attributes is the grammar's (grammar.h). Nothing is
// converted here: the form of a value is decided, in the same way as by the generated schemas.
// Covered by tests/load/grammar_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// What the value of an attribute must look like.
enum class ValueType : std::uint8_t {
    text,        ///< anything
    int32,       ///< -?[0-9]+, or one of the choices: a name that stands for an integer
    int64,       ///< likewise
    count,       ///< [0-9]+
    number,      ///< a decimal number: 1, -0.5, .5, 1e-3; not inf or nan
    boolean,     ///< 0, 1, true, false, True, False, TRUE or FALSE
    key,         ///< only {key}: what an output is written to
    name,        ///< no blanks
    names,       ///< names between blanks, at least one
    script,      ///< a script; the compiler reads it
    expression,  ///< likewise, an expression
    choice,      ///< one of the choices
};

/// One attribute of an element, or port of a node.
struct AttributeRule {
    std::string name;
    ValueType type = ValueType::text;
    bool required = false;
    bool constant_in_json = false;  ///< required, but JSON may leave it out: it has one value
    bool may_be_pointer = false;    ///< {key} is accepted whatever the type
    std::string initial;            ///< what holds if it is missing; empty: nothing, or see `doc`
    std::string unit;               ///< of the value; empty: none
    std::vector<std::string> choices;
    std::string doc;
};

/// Whether `value` is what the attribute takes: of its type, or a {key} where one may stand.
bool accepts(const AttributeRule& rule, std::string_view value);

/// Whether an accepted integer fits its type; true for values of other types.
bool in_range(const AttributeRule& rule, std::string_view value);

/// Whether `value` has the form of a blackboard pointer: {key}, with blanks around it or not.
bool is_pointer(std::string_view value);

/// What the attribute takes, for messages: "a number in m/s or a {key}".
std::string expectation(const AttributeRule& rule);

/// A regular expression that matches exactly what accepts() accepts, understood by XSD and by JSON
/// Schema (which has to anchor it); empty if every text is accepted.
std::string pattern(const AttributeRule& rule);

}  // namespace trellis
