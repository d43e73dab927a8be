// Property: what is loaded without errors runs: 50 ticks end in a status or a fault with words, the
// state survives save() and restore(), and halting ends.
// SPDX-License-Identifier: MIT
#include "sim/bridge/leaves.h"
#include "sim/roomba.h"
#include "support/survival.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace trellis;
    static const Registry& registry = []() -> Registry& {
        static Registry made;
        register_roomba(made);
        return made;
    }();
    Roomba robot;
    test::Survival survival;
    test::survive({reinterpret_cast<const char*>(data), size}, registry, robot, survival);
    return 0;
}
