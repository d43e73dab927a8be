// Registering leaves: what is read off a struct, the numbers of its members, hosts and sensors.
// SPDX-License-Identifier: MIT
#include "core/leaf.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace trellis {
namespace {

struct Robot {
    double x = 0.0;
    bool bumper = false;
    std::int32_t count = 0;
};

struct Nothing {
    bool tick(const Tick&) const { return true; }
};
struct Three {
    double a = 1.5;
    std::int32_t b = 2;
    std::string_view c = "three";
    Status tick(Robot& robot, const Tick& t) {
        robot.x = a + t.time();
        return Status::running;
    }
    void halt(Robot& robot) const { robot.x = -1.0; }
};
struct Ports {
    Maybe<double> maybe;
    Out<std::int32_t> out;
    Out<std::string_view> both;
    const Value* any = nullptr;
    std::int64_t large = 0;
    std::int32_t kept = 0;
    Status tick(const Tick&) { return Status::success; }
};

// every member of a struct is counted, so that a forgotten one is noticed
static_assert(detail::member_count<Nothing>() == 0);
static_assert(detail::member_count<Three>() == 3);
static_assert(detail::member_count<Ports>() == 6);

void fill(Registry& registry) {
    registry.add<Nothing, Robot>("Nothing", "succeed");
    registry.add<Three, Robot>("Three", "three inputs")
        .input("a", &Three::a, "m", "a distance")
        .input("b", &Three::b)
        .input("c", &Three::c)
        .required();
    registry.add<Ports, Robot>("Ports", "every kind of port")
        .input("maybe", &Ports::maybe)
        .output("out", &Ports::out)
        .inout("both", &Ports::both)
        .input("any", &Ports::any)
        .input("large", &Ports::large)
        .state(&Ports::kept);
    registry.sensor("x", &Robot::x, "m", "position");
    registry.sensor("bumper", &Robot::bumper, "", "touched");
    registry.enumerator("RED", 1);
}

}  // namespace

TEST_CASE("leaf: what is read off the struct: kind, host, size, defaults") {
    Registry registry;
    fill(registry);
    const LeafType& nothing = *registry.find("Nothing");
    CHECK(nothing.condition);
    CHECK(nothing.synchronous);
    CHECK(nothing.host_tag == nullptr);
    CHECK((nothing.halt == nullptr));
    const LeafType& three = *registry.find("Three");
    CHECK_FALSE(three.condition);
    Robot robot;
    CHECK(three.host_tag == HostRef(robot).tag);
    CHECK(three.size == sizeof(Three));
    CHECK(three.ports[0].initial == Value::real(1.5));
    CHECK(three.ports[1].initial == Value::integer(2));
    CHECK(three.ports[2].initial == Value::text("three"));
    CHECK(three.find("a")->unit == "m");
    CHECK_FALSE(three.find("a")->required);
    CHECK(three.find("c")->required);
    CHECK(three.find("d") == nullptr);
    CHECK(registry.find("Four") == nullptr);
}

TEST_CASE("leaf: ports have types, directions and, where they may be absent, a flag") {
    Registry registry;
    fill(registry);
    std::string all;
    for (const Port& port : registry.find("Ports")->ports) {
        all += port.name + ' ' + std::string(name_of(port.direction)) + ' ' +
               std::string(name_of(port.type)) + (port.present != Port::always ? " ?\n" : "\n");
    }
    CHECK(all == "maybe input double ?\nout output int ?\nboth inout std::string ?\nany input \n"
                 "large input int64_t\n");
    CHECK(registry.find("Ports")->state.size() == 1);
}

TEST_CASE("leaf: calls reach the struct through its erased type") {
    Registry registry;
    fill(registry);
    const LeafType& three = *registry.find("Three");
    alignas(Three) std::byte bytes[sizeof(Three)];
    three.construct(bytes);
    Robot robot;
    CHECK(three.tick(bytes, &robot, {.count = 4, .dt = 0.5}) == Status::running);
    CHECK(robot.x == 3.5);
    three.halt(bytes, &robot);
    CHECK(robot.x == -1.0);
}

TEST_CASE("leaf: sensors and enumerators are found by name") {
    Registry registry;
    fill(registry);
    REQUIRE(registry.host().find("bumper") != nullptr);
    CHECK(registry.host().find("bumper")->type == PortType::boolean);
    CHECK(registry.host().find("x")->unit == "m");
    CHECK(registry.host().find("y") == nullptr);
    CHECK(registry.enumerators().front().first == "RED");
}

}  // namespace trellis
