// What a world file can say, as a table, and the JSON Schema that is made of it. What the members
// mean is read by world_file.h. Covered by tests/sim/world_file_test.cpp and, for the schema,
// tests/golden/schemas_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"
#include "load/json_tree.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace trellis {

/// The objects of a world file.
enum class WorldObject : std::uint8_t {
    none,
    world,
    robot,
    start,
    outline,
    door,
    dirt,
    dock,
    battery,
    noise,
};

/// One member of an object.
struct WorldMember {
    enum class Kind : std::uint8_t { text, number, point, points, object, list };
    enum class Need : std::uint8_t { optional, needed };
    /// What numbers make sense; `place` is at most 1,000 away from 0, any other at most 1,000,000.
    enum class Limit : std::uint8_t { any, place, from_0, above_0, part };

    WorldObject object;
    std::string_view name;
    Kind kind;
    WorldObject of;  ///< the object's or the list's values; else none
    Need need;
    Limit limit;
    std::string_view doc;
};

/// All of them, the members of one object together.
std::span<const WorldMember> world_members();

/// "a robot", "a spot of dirt": for messages.
std::string_view article(WorldObject object);

/// Checks a file's values against the table: everything that a JSON Schema can say. Errors
/// "json-type", "json-member" and "bad-value", all structural.
void check_world(const JsonTree& json, Diagnostics& diagnostics);

/// The JSON Schema (draft 7) of world files.
std::string world_schema();

}  // namespace trellis
