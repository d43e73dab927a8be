// What names mean in the expressions of a machine. Private to runtime/load.
// Covered by tests/load/compile_machine_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/builder.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace trellis {

/// The names that one machine declares. Variables have one scope; elapsed() depends on the state.
struct MachineScope {
    std::unordered_map<std::string_view, RowId> states;
    std::unordered_map<std::string, SlotId> variables;
    std::unordered_map<std::string_view, SlotId> system;  ///< those that are used
};

class MachineNames final : public Names {
public:
    /// For an expression at `where`, inside state row `state`.
    MachineNames(Builder& builder, MachineScope& scope, RowId state, Builder::Text text)
        : builder_(builder), scope_(scope), state_(state), text_(text) {}
    /// A <script>, which may make variables by assigning to them (SCXML 5.8).
    MachineNames& of_script() {
        may_create_ = true;
        return *this;
    }

    Meaning variable(std::string_view name, Use use) override;
    Meaning sensor(std::string_view name) override { return builder_.sensor(name); }
    Meaning elapsed() override;
    Meaning state(std::string_view name) override;

private:
    Meaning system_variable(std::string_view name);

    Builder& builder_;
    MachineScope& scope_;
    RowId state_;
    Builder::Text text_;
    bool may_create_ = false;
};

}  // namespace trellis
