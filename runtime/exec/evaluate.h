// Runs compiled expressions. An evaluation reads and writes what its context points to and nothing
// else; it allocates only where texts, arrays or objects grow beyond what their variables have held
// before. Evaluation cannot loop: code only jumps forward. Trees differ from machines as
// BehaviorTree.CPP differs from SCXML (core/code.h, Dialect); the rules are in evaluate_tree.cpp
// and evaluate_machine.cpp. Covered by tests/exec/evaluate_test.cpp (against a slow reference) and
// tests/exec/scripts_test.cpp (963 recorded scripts of BehaviorTree.CPP).
//
//     EvalContext context;                      // one per State that is being stepped, filled once
//     per step context.use(program.code, state.slots.data(), scratch.data());   // scratch:
//     code.temporaries Values context.row_memory = ...; context.cycle = ...; context.dt = ...; if
//     (evaluate_condition(program.code, id, context) == Truth::failed) report(context.error);
// SPDX-License-Identifier: MIT
#pragma once

#include "core/code.h"
#include "core/ids.h"
#include "core/random.h"
#include "core/value.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace trellis {

/// The last failure of an evaluation. `left` and `right` are the kinds of the operands a and b.
struct EvalError {
    EvalErrorKind kind = EvalErrorKind::none;
    std::uint32_t instruction = 0;  ///< in CodeTable::instructions and offsets
    Value::Kind left = Value::Kind::undefined;
    Value::Kind right = Value::Kind::undefined;
};

/// What an evaluation reads and writes. All pointers are borrowed; those that no code of the table
/// needs may be null.
struct EvalContext {
    std::array<const Value*, 3> base = {};  ///< by Space: constants, slots, temporaries
    Value* slots = nullptr;
    Value* temporaries =
        nullptr;  ///< CodeTable::temporaries values of any content, kept between calls
    std::uint8_t* entry_types = nullptr;  ///< an EntryType per slot; trees only
    std::uint32_t* writes =
        nullptr;  ///< per slot, incremented by every assignment; null: not counted
    const std::uint32_t* row_memory = nullptr;  ///< of elapsed_count and elapsed_since
    std::uint32_t cycle = 0;                    ///< of elapsed_since
    double dt = 0;                              ///< s per cycle
    const std::byte* host = nullptr;            ///< the struct whose members the sensors are
    Random* random = nullptr;
    bool (*in_state)(const void* world, RowId row) = nullptr;  ///< of In('s')
    /// Of In() of a name only known at run time: row of that state, no row if there is none.
    RowId (*state_named)(const void* world, std::string_view name) = nullptr;
    const void* world = nullptr;  ///< first argument of the two above
    EvalError error;              ///< of the last evaluation that failed

    /// Points at the constants of `code`, the variables and the temporaries.
    void use(const CodeTable& code, Value* variables, Value* scratch) {
        slots = variables;
        temporaries = scratch;
        base = {code.constants.data(), variables, scratch};
    }
};

/// The outcome of a condition. `failed`: EvalContext::error says why.
enum class Truth : std::uint8_t { no, yes, failed };

/// Evaluates `id` and copies its value into `result`. False, and EvalContext::error, if it failed;
/// then assignments that came before the failure have happened, and `result` is as it was.
bool evaluate(const CodeTable& code, CodeId id, EvalContext& context, Value& result);

/// The same for the effects only.
bool execute(const CodeTable& code, CodeId id, EvalContext& context);

/// The same for a condition. Trees: a real is true unless 0, an integer must be 0 or 1, anything
/// else fails. Machines: undefined, null, false, 0 and '' are false, anything else is true.
Truth evaluate_condition(const CodeTable& code, CodeId id, EvalContext& context);

/// The same for a number; false booleans are 0, true ones 1. False if it failed or is no number.
bool evaluate_real(const CodeTable& code, CodeId id, EvalContext& context, double& result);

/// The failure in words, for example `operator - does not take text and real`. Variables are named
/// by `slot_names` where it knows them.
std::string describe(const EvalError& error, const CodeTable& code,
                     std::span<const std::string> slot_names = {});

}  // namespace trellis
