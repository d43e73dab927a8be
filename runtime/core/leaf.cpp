// Look-ups by name in registries, and the names of port types.
// SPDX-License-Identifier: MIT
#include "core/leaf.h"

namespace trellis {

namespace {

template <class Named>
const Named* named(const Named* first, const Named* last, std::string_view name) {
    for (; first != last; ++first) {
        if (first->name == name) { return first; }
    }
    return nullptr;
}

}  // namespace

std::string_view name_of(PortType type) {
    static constexpr std::string_view names[] = {"",        "bool",   "int",
                                                 "int64_t", "double", "std::string"};
    return names[static_cast<std::size_t>(type)];
}

std::string_view name_of(PortDirection direction) {
    static constexpr std::string_view names[] = {"input", "output", "inout"};
    return names[static_cast<std::size_t>(direction)];
}

const Sensor* HostType::find(std::string_view sensor) const {
    return named(sensors.data(), sensors.data() + sensors.size(), sensor);
}

const Port* LeafType::find(std::string_view port) const {
    return named(ports.data(), ports.data() + ports.size(), port);
}

const LeafType* Registry::find(std::string_view name) const {
    for (const LeafType& type : types_) {
        if (type.name == name) { return &type; }
    }
    return nullptr;
}

}  // namespace trellis
