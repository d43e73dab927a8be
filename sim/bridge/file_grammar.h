// What a JSON file can say, as a table of its objects and their members: checking a file against
// it, the JSON Schema that is made of it, and taking values out of a file that was checked. World
// files (world_grammar.h) and sweep files (runner/sweep/spec.h) have such tables. Covered by
// tests/sim/world_file_test.cpp, tests/runner/sweep_spec_test.cpp and, for the schemas,
// tests/golden/schemas_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"
#include "load/json_tree.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// One member of an object.
struct FileMember {
    enum class Kind : std::uint8_t {
        text,
        number,
        whole,     ///< a number without a fraction
        flag,      ///< true or false
        point,     ///< [x, y]
        points,    ///< at least 3 of them
        texts,     ///< a list of texts
        numbers,   ///< a list of numbers
        scalars,   ///< a list of numbers, texts and booleans
        settings,  ///< an object with any members, each a number, a text or a boolean
        object,    ///< one of FileGrammar::objects
        list,      ///< a list of those
    };
    enum class Need : std::uint8_t { optional, needed };
    /// What numbers make sense; `place` is at most 1,000 away from 0, any other at most 1,000,000.
    enum class Limit : std::uint8_t { any, place, from_0, above_0, part, cell };

    std::uint8_t object;  ///< whose member it is: a number in FileGrammar::objects
    std::string_view name;
    Kind kind;
    std::uint8_t of;  ///< the object's or the list's values, likewise; else 0
    Need need;        ///< a list that is needed must not be empty
    Limit limit;
    std::string_view doc;
};

/// An object of a file.
struct FileObject {
    std::string_view name;     ///< in the schema
    std::string_view article;  ///< "a robot", "a spot of dirt": for messages
};

/// Everything that a kind of file can say. Every object also takes "doc" (a text) and members that
/// begin with $, which are for editors.
struct FileGrammar {
    std::string_view title;               ///< of the schema
    std::span<const FileObject> objects;  ///< the first is not used, the second is the whole file
    std::span<const FileMember> members;  ///< those of one object together
};

/// Checks a file's values against the table: everything that a JSON Schema can say. Errors
/// "json-type", "json-member" and "bad-value", all structural.
void check_file(const JsonTree& json, const FileGrammar& grammar, Diagnostics& diagnostics);

/// The JSON Schema (draft 7) of such files.
std::string file_schema(const FileGrammar& grammar);

/// Values of a file in which check_file() finds no error. What is not there is empty, or
/// `otherwise`.
std::string text_in(const JsonTree& json, JsonId object, std::string_view key);
double number_in(const JsonTree& json, JsonId object, std::string_view key, double otherwise);
std::vector<JsonId> list_in(const JsonTree& json, JsonId object, std::string_view key);

}  // namespace trellis
