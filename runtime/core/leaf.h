// Leaves: how a host's actions and conditions, written as plain structs, become something a program
// can name. Also the sensors a host shows to expressions. Nothing here knows documents or ticks.
// Covered by tests/core/leaf_test.cpp.
// SPDX-License-Identifier: MIT

//     struct MoveForward {
//         double speed = 0.5;     // m/s  input
//         double duration = 3.0;  // s    input
//         int ticks = 0;          //      state
//         Status tick(Roomba& robot, const Tick& t);
//         void halt(Roomba& robot);  // optional: abandoned while running
//     };
//     registry.add<MoveForward, Roomba>("MoveForward", "drive straight until a time has passed")
//         .input("speed", &MoveForward::speed, "m/s")
//         .input("duration", &MoveForward::duration, "s")
//         .state(&MoveForward::ticks);
//
// Every member is named in the registration: a State compares, hashes and saves exactly those.
#pragma once

#include "core/random.h"
#include "core/status.h"
#include "core/value.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace trellis {

/// Passed to every leaf: the only clock and the only source of chance it may use.
struct Tick {
    std::uint64_t count = 0;   ///< ticks completed before this one
    double dt = 0.0;           ///< s, length of one tick
    Random* random = nullptr;  ///< the run's generator, never null during a tick

    double time() const { return static_cast<double>(count) * dt; }  ///< s, since the run began
};

/// A port that may have no value: an input that a document need not give, or cannot be read now.
template <class T>
struct Maybe {
    T value{};
    bool present = false;

    explicit operator bool() const { return present; }
    const T& operator*() const { return value; }
};

/// A port that a leaf writes. What was assigned during a tick is stored when the tick returns; a
/// text must stay alive until then.
template <class T>
struct Out {
    T value{};
    bool present = false;

    Out& operator=(T v) {
        value = v;
        present = true;
        return *this;
    }
};

/// What a port or a sensor holds. `any` is a `const Value*`, valid during the tick, null if unset.
enum class PortType : std::uint8_t { any, boolean, int32, int64, real, text };

/// As BehaviorTree.CPP spells them in a TreeNodesModel: "bool", "int", "double", "std::string", …
std::string_view name_of(PortType type);

enum class PortDirection : std::uint8_t { input, output, inout };

/// "input", "output", "inout".
std::string_view name_of(PortDirection direction);

struct Port {
    static constexpr std::uint32_t always = 0xFFFFFFFF;

    std::string name, unit, doc;
    PortType type = PortType::real;
    PortDirection direction = PortDirection::input;
    bool required = false;           ///< a document must give it
    Value initial;                   ///< the member's own initial value; undefined for outputs
    std::uint32_t offset = 0;        ///< bytes from the start of the leaf struct
    std::uint32_t present = always;  ///< offset of Maybe::present or Out::present
};

/// A member that is neither input nor output: kept from tick to tick, part of a State.
struct StateMember {
    std::uint32_t offset = 0, size = 0;  ///< bytes
};

/// A value of the host that expressions read as `_x.NAME`.
struct Sensor {
    std::string name, unit, doc;
    PortType type = PortType::real;  ///< boolean, int32 or real
    std::uint32_t offset = 0;        ///< bytes from the start of the host struct
};

/// The struct that leaves act on: its identity and its sensors.
struct HostType {
    const void* tag = nullptr;
    std::vector<Sensor> sensors;

    const Sensor* find(std::string_view sensor) const;
};

/// A leaf with its C++ type erased: what the compiler binds and the interpreter calls.
struct LeafType {
    std::string name, doc;
    std::vector<Port> ports;  ///< in the order of registration
    std::vector<StateMember> state;
    /// Answers at once: never running, called in every tick whatever it answered before.
    bool synchronous = false;
    bool condition = false;  ///< returns a bool; shown as Condition, else as Action
    /// More than 0: no leaf, but a control or, with 1, a decorator of another host, with `tick`
    /// null. Files that use it can be loaded and looked at, not stepped.
    std::uint32_t most_children = 0;
    std::uint32_t size = 0, align = 1;  ///< bytes
    const void* host_tag = nullptr;     ///< the host it acts on; null: none
    void (*construct)(std::byte*) = nullptr;
    Status (*tick)(std::byte*, void* host, const Tick&) = nullptr;
    void (*halt)(std::byte*, void* host) = nullptr;  ///< null: nothing to do

    const Port* find(std::string_view port) const;
};

namespace detail {

/// One address per host type; comparing them replaces RTTI. Not const, so that no two are merged.
template <class Host>
inline char host_tag = 0;

template <class T>
struct PortTraits;  // for the member types a port may have
template <>
struct PortTraits<bool> {
    static constexpr PortType type = PortType::boolean;
};
template <>
struct PortTraits<std::int32_t> {
    static constexpr PortType type = PortType::int32;
};
template <>
struct PortTraits<std::int64_t> {
    static constexpr PortType type = PortType::int64;
};
template <>
struct PortTraits<double> {
    static constexpr PortType type = PortType::real;
};
template <>
struct PortTraits<std::string_view> {
    static constexpr PortType type = PortType::text;
};
template <>
struct PortTraits<const Value*> {
    static constexpr PortType type = PortType::any;
};

inline Value port_value(bool v) {
    return Value::boolean(v);
}
inline Value port_value(std::int32_t v) {
    return Value::integer(v);
}
inline Value port_value(std::int64_t v) {
    return Value::integer(v);
}
inline Value port_value(double v) {
    return Value::real(v);
}
inline Value port_value(std::string_view v) {
    return Value::text(v);
}
inline Value port_value(const Value*) {
    return {};
}

/// Converts to any member type: counts the members of an aggregate below.
struct AnyMember {
    template <class T>
    operator T() const;
};

/// Number of members of a plain struct, found by how many initialisers it takes.
template <class T, class... Members>
constexpr std::size_t member_count() {
    if constexpr (requires { T{std::declval<Members>()..., std::declval<AnyMember>()}; }) {
        return member_count<T, Members..., AnyMember>();
    } else {
        return sizeof...(Members);
    }
}

template <class Leaf, class Host>
concept ticks_with_host = requires(Leaf leaf, Host& host, const Tick& tick) {
    leaf.tick(host, tick);
};
template <class Leaf, class Host>
concept halts_with_host = requires(Leaf leaf, Host& host) {
    leaf.halt(host);
};

template <class Class, class Member>
std::uint32_t offset_of(const Class& probe, Member Class::*member) {
    return static_cast<std::uint32_t>(reinterpret_cast<const char*>(&(probe.*member)) -
                                      reinterpret_cast<const char*>(&probe));
}

}  // namespace detail

/// A leaf struct is at most this large: it is copied on entry, and each use of it lies in a State.
inline constexpr std::size_t max_leaf_size = 4096;  // bytes

/// Describes one leaf type while it is being registered.
template <class Leaf>
class LeafBuilder {
public:
    explicit LeafBuilder(LeafType& type) : type_(&type) {}
    LeafBuilder(const LeafBuilder&) = delete;
    LeafBuilder& operator=(const LeafBuilder&) = delete;
    /// Asserts that every member of the struct was named.
    ~LeafBuilder() {
        assert(type_->ports.size() + type_->state.size() == detail::member_count<Leaf>() &&
               "register every member of a leaf as input, output, inout or state");
    }

    /// A member that a document may set; its initial value is the port's default.
    template <class T>
    LeafBuilder& input(std::string name, T Leaf::*member, std::string unit = {},
                       std::string doc = {}) {
        Port& port =
            add<T>(std::move(name), PortDirection::input, member, std::move(unit), std::move(doc));
        port.initial = detail::port_value(Leaf{}.*member);
        return *this;
    }
    template <class T>
    LeafBuilder& input(std::string name, Maybe<T> Leaf::*member, std::string unit = {},
                       std::string doc = {}) {
        Port& port =
            add<T>(std::move(name), PortDirection::input, member, std::move(unit), std::move(doc));
        port.present = port.offset + flag_offset<Maybe<T>>();
        return *this;
    }
    template <class T>
    LeafBuilder& output(std::string name, Out<T> Leaf::*member, std::string unit = {},
                        std::string doc = {}) {
        return output_port(std::move(name), PortDirection::output, member, std::move(unit),
                           std::move(doc));
    }
    /// Read before each tick, and stored after a tick that assigned it.
    template <class T>
    LeafBuilder& inout(std::string name, Out<T> Leaf::*member, std::string unit = {},
                       std::string doc = {}) {
        return output_port(std::move(name), PortDirection::inout, member, std::move(unit),
                           std::move(doc));
    }
    /// A member that is kept from tick to tick.
    template <class T>
    LeafBuilder& state(T Leaf::*member) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>,
                      "a state member must have no padding of its own");
        type_->state.push_back(
            {detail::offset_of(Leaf{}, member), static_cast<std::uint32_t>(sizeof(T))});
        return *this;
    }
    /// A document must give the port that was registered last.
    LeafBuilder& required() {
        type_->ports.back().required = true;
        return *this;
    }
    /// The leaf answers at once though it returns a Status: running is an error.
    LeafBuilder& synchronous() {
        type_->synchronous = true;
        return *this;
    }

private:
    template <class Flagged>
    static std::uint32_t flag_offset() {
        return detail::offset_of(Flagged{}, &Flagged::present);
    }
    template <class T, class Member>
    Port& add(std::string name, PortDirection direction, Member Leaf::*member, std::string unit,
              std::string doc) {
        Port port;
        port.name = std::move(name);
        port.unit = std::move(unit);
        port.doc = std::move(doc);
        port.type = detail::PortTraits<T>::type;
        port.direction = direction;
        port.offset = detail::offset_of(Leaf{}, member);
        type_->ports.push_back(std::move(port));
        return type_->ports.back();
    }
    template <class T>
    LeafBuilder& output_port(std::string name, PortDirection direction, Out<T> Leaf::*member,
                             std::string unit, std::string doc) {
        Port& port = add<T>(std::move(name), direction, member, std::move(unit), std::move(doc));
        port.present = port.offset + flag_offset<Out<T>>();
        return *this;
    }

    LeafType* type_;
};

/// The leaves and sensors a host offers to documents, by name. Programs point into it: it must
/// outlive them and may not be copied.
class Registry {
public:
    Registry() = default;
    Registry(const Registry&) = delete;
    Registry& operator=(const Registry&) = delete;

    /// Registers `Leaf` under `name`. `Leaf` is a plain, trivially copyable struct with
    ///     Status tick(Host&, const Tick&);   // or tick(const Tick&): needs no host
    ///     bool tick(Host&, const Tick&);     // a condition: true = success, false = failure
    ///     void halt(Host&);                  // optional: called when abandoned while running
    /// A fresh `Leaf{}` is made each time the leaf is entered: there is no reset to forget.
    template <class Leaf, class Host>
    LeafBuilder<Leaf> add(std::string name, std::string doc) {
        static_assert(std::is_trivially_copyable_v<Leaf> && std::is_aggregate_v<Leaf>,
                      "a leaf is a plain struct, so that a State is a value");
        static_assert(sizeof(Leaf) <= max_leaf_size && alignof(Leaf) <= alignof(std::max_align_t));
        LeafType& type = types_.emplace_back();
        type.name = std::move(name);
        type.doc = std::move(doc);
        type.size = sizeof(Leaf);
        type.align = alignof(Leaf);
        type.construct = [](std::byte* p) { new (p) Leaf{}; };
        constexpr bool with_host = detail::ticks_with_host<Leaf, Host>;
        if constexpr (with_host) {
            type.host_tag = &detail::host_tag<Host>;
            host_.tag = type.host_tag;
        }
        type.tick = [](std::byte* p, void* host, const Tick& tick) {
            Leaf& leaf = *std::launder(reinterpret_cast<Leaf*>(p));
            const auto result = [&] {
                if constexpr (with_host) {
                    return leaf.tick(*static_cast<Host*>(host), tick);
                } else {
                    return leaf.tick(tick);
                }
            }();
            if constexpr (std::is_same_v<decltype(result), const bool>) {
                return result ? Status::success : Status::failure;
            } else {
                return result;
            }
        };
        if constexpr (detail::halts_with_host<Leaf, Host>) {
            type.halt = [](std::byte* p, void* host) {
                std::launder(reinterpret_cast<Leaf*>(p))->halt(*static_cast<Host*>(host));
            };
        }
        type.condition = returns_bool<Leaf, Host>();
        type.synchronous = type.condition;
        return LeafBuilder<Leaf>(type);
    }

    /// Adds a leaf whose description was not made from a struct, in the place of the one of that
    /// name if there is one; no program may use that yet. Its ports lie in `size` bytes that are
    /// zero before `construct`.
    void add(LeafType type) {
        for (LeafType& known : types_) {
            if (known.name == type.name) {
                known = std::move(type);
                return;
            }
        }
        types_.push_back(std::move(type));
    }

    /// Shows a member of the host to expressions, as `_x.NAME`.
    template <class Host, class T>
    void sensor(std::string name, T Host::*member, std::string unit, std::string doc) {
        static_assert(std::is_same_v<T, bool> || std::is_same_v<T, std::int32_t> ||
                      std::is_same_v<T, double>);
        host_.tag = &detail::host_tag<Host>;
        host_.sensors.push_back({std::move(name), std::move(unit), std::move(doc),
                                 detail::PortTraits<T>::type, detail::offset_of(Host{}, member)});
    }

    /// A name for a number in expressions of trees, as registerScriptingEnum in BehaviorTree.CPP.
    void enumerator(std::string name, std::int64_t number) {
        enumerators_.emplace_back(std::move(name), number);
    }

    /// The leaf of that name, or null.
    const LeafType* find(std::string_view name) const;
    const std::deque<LeafType>& leaves() const { return types_; }  ///< in order of registration
    const HostType& host() const { return host_; }
    const std::vector<std::pair<std::string, std::int64_t>>& enumerators() const {
        return enumerators_;
    }

private:
    template <class Leaf, class Host>
    static constexpr bool returns_bool() {
        if constexpr (detail::ticks_with_host<Leaf, Host>) {
            return std::is_same_v<decltype(std::declval<Leaf&>().tick(std::declval<Host&>(),
                                                                      std::declval<const Tick&>())),
                                  bool>;
        } else {
            return std::is_same_v<decltype(std::declval<Leaf&>().tick(std::declval<const Tick&>())),
                                  bool>;
        }
    }

    std::deque<LeafType> types_;  // a deque: LeafCall keeps pointers into it
    HostType host_;
    std::vector<std::pair<std::string, std::int64_t>> enumerators_;
};

/// The object that leaves act on during a run, with its type remembered.
struct HostRef {
    void* object = nullptr;
    const void* tag = nullptr;

    HostRef() = default;
    template <class Host>
    requires(!std::is_same_v<Host, HostRef>) HostRef(Host& host)
        : object(&host), tag(&detail::host_tag<Host>) {}
};

}  // namespace trellis
