// Calling the host's leaves: fresh on entry, inputs before and outputs after each tick.
// Covered by tests/exec/leaves_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/ports.h"
#include "exec/stepper.h"

#include <cstring>

namespace trellis {

Status Stepper::did_not_answer(RowId n, const LeafCall& leaf) {
    return fault(Fault::Kind::leaf_status, n,
                 leaf.type->name + " must answer at once but returned RUNNING");
}

Status Stepper::returned_idle(RowId n, const LeafCall& leaf) {
    return fault(Fault::Kind::leaf_status, n, leaf.type->name + " returned IDLE");
}

void Stepper::halt_leaf(RowId n) {
    const LeafCall& leaf = p_.call(n);
    trace({.kind = TraceEvent::Kind::halt, .row = n});
    if (leaf.type->halt == nullptr) { return; }
    std::byte* self = s_.leaves.data() + leaf.offset;
    if (leaf.input_count != 0) { point_inputs(leaf, self); }
    leaf.type->halt(self, host_);
}

// Lets text and any-typed members point into this state again: it may have been copied or restored
// since the last tick.
void Stepper::point_inputs(const LeafCall& leaf, std::byte* self) {
    for (std::uint32_t i = leaf.first_input; i < leaf.first_input + leaf.input_count; ++i) {
        const Port& port = leaf.type->ports[p_.live_inputs[i].port];
        if (port.type != PortType::text && port.type != PortType::any) { continue; }
        Value& value = s_.inputs[i];
        if (value.is(Value::Kind::undefined)) {
            static_cast<void>(evaluate(p_.code, p_.live_inputs[i].code, context(), value));
        }
        static_cast<void>(store_input(port, value, self));
    }
}

bool Stepper::read_inputs(RowId n, const LeafCall& leaf, std::byte* self) {
    for (std::uint32_t i = 0; i < leaf.input_count; ++i) {
        const LiveInput& input = p_.live_inputs[leaf.first_input + i];
        const Port& port = leaf.type->ports[input.port];
        double value = 0.0;
        if (input.formula) {
            value = compute(forms(), p_.formulas[input.formula.index]);
            std::memcpy(self + input.offset, &value, sizeof value);
            continue;
        }
        if (port.type == PortType::real && port.present == Port::always) {
            if (evaluate_real(p_.code, input.code, context(), value)) {
                std::memcpy(self + port.offset, &value, sizeof value);
                continue;
            }
        }
        if (!read_input(n, leaf.first_input + i, self)) { return false; }
    }
    return true;
}

// The general case: an input of any type that may be absent. A variable that does not exist, or
// does not convert, is an absent value for a Maybe and a fault for a plain member. The value is
// kept in the state, because a text or any-typed member points to it during the tick.
bool Stepper::read_input(RowId n, std::uint32_t input, std::byte* self) {
    const LiveInput& live = p_.live_inputs[input];
    const Port& port = p_.call(n).type->ports[live.port];
    Value& value = s_.inputs[input];
    const bool evaluated = evaluate(p_.code, live.code, context(), value);
    const bool stored = evaluated && store_input(port, value, self);
    // a <param> that fails is left out (SCXML 5.7)
    const bool is_param = rows_[rows_[n.index].parent.index].op == Op::invoke;
    if (!evaluated && is_param) { raise_error(n); }
    if (port.present != Port::always) {
        // for an in/out port the flag says what the leaf assigns
        const bool present = stored && port.direction == PortDirection::input;
        std::memcpy(self + port.present, &present, sizeof present);
        return true;
    }
    if (stored) { return true; }
    if (is_param) { return true; }
    if (port.type == PortType::any) {
        const Value* unset = nullptr;
        std::memcpy(self + port.offset, &unset, sizeof unset);
        return true;
    }
    const std::string what =
        evaluated ? print(value) + " is not of type " + std::string(name_of(port.type))
                  : evaluation_error();
    fault(Fault::Kind::expression, n, "input \"" + port.name + "\": " + what);
    return false;
}

bool Stepper::write_outputs(RowId n, const LeafCall& leaf, std::byte* self) {
    for (std::uint32_t i = 0; i < leaf.output_count; ++i) {
        const BoundOutput& output = p_.bound_outputs[leaf.first_output + i];
        const Port& port = leaf.type->ports[output.port];
        bool present = false;
        std::memcpy(&present, self + port.present, sizeof present);
        if (!present) { continue; }
        std::memset(self + port.present, 0, sizeof present);
        std::string why;
        if (!store_output(port, self, s_.slots[output.slot.index], s_.entries[output.slot.index],
                          why)) {
            fault(Fault::Kind::output, n, "output \"" + port.name + "\": " + why);
            return false;
        }
        count_write(output.slot);
    }
    return true;
}

}  // namespace trellis
