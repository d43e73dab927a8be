// Compiled expressions: three-address instructions over constants, variables (slots) and
// temporaries, flat and without pointers. load/emit.h writes them, exec/evaluate.h runs them,
// dump() prints them. Nothing here evaluates anything. Covered by tests/exec/evaluate_test.cpp.
//
//     elapsed() > limit       elapsed_since t0 row 4
//                             greater       t0 t0 s7   last
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/value.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// The two settings of the expression language. Trees: BehaviorTree.CPP to the letter (both
/// operands of && and || are evaluated, a variable keeps its first type, == has a tolerance).
/// Machines: short-circuit, dynamic types, exact ==.
enum class Dialect : std::uint8_t { tree, machine };

/// The operations, listed and explained in core/code_ops.def.
enum class CodeOp : std::uint8_t {
#define CODE_OP(name, meaning) name,
#include "core/code_ops.def"
};

/// The functions, listed and explained in core/functions.def.
enum class Function : std::uint8_t {
#define FUNCTION(name, fewest, most, meaning) name,
#include "core/functions.def"
};

/// What the loader checks and suggests about a function.
struct FunctionInfo {
    std::string_view name;
    std::uint8_t fewest;
    std::uint8_t most;         ///< arguments; any_number: no upper limit
    std::string_view meaning;  ///< one line for the manual

    static constexpr std::uint8_t any_number = 255;
};

/// All functions, indexed by Function.
std::span<const FunctionInfo> functions();

/// Where an operand lies: EvalContext::base[space][index].
enum class Space : std::uint8_t { constant, slot, temporary };

/// One operand: 4 bits space, 28 bits index, so that masking the space leaves the index in bytes.
class Operand {
public:
    static constexpr std::uint32_t max_index = 0x0FFFFFFF;

    constexpr Operand() = default;
    constexpr Operand(Space space, std::uint32_t index)
        : bits_(index * sizeof(Value) | static_cast<std::uint32_t>(space)) {}

    constexpr Space space() const { return static_cast<Space>(bits_ & 15); }
    constexpr std::uint32_t index() const { return bits_ >> 4; }
    friend constexpr bool operator==(Operand, Operand) = default;

private:
    static_assert(sizeof(Value) == 16);

    std::uint32_t bits_ = 0;
};

/// The operand of instructions that have none: constant 0, which is undefined in every table that
/// is not empty.
inline constexpr Operand no_operand;

/// Temporary 0. Only an instruction that reads it directly after the one that computes it uses it,
/// and only for numbers, so that evaluation can keep it in a register.
inline constexpr Operand accumulator_operand(Space::temporary, 0);

/// The temporary whose content the code of an <assign> stores: see emit_store() in load/emit.h.
inline constexpr std::uint32_t stored_temporary = 1;

/// What went wrong. exec/evaluate.h describes it in words.
enum class EvalErrorKind : std::uint8_t {
    none,
    undeclared,         ///< the name means nothing here
    read_only,          ///< the name cannot be assigned to
    not_assignable,     ///< left of := is no variable
    missing,            ///< the tree's variable does not exist (yet)
    empty,              ///< the tree's variable or operand has no value
    operands,           ///< the operator does not take these kinds
    not_integral,       ///< a bitwise operator needs whole numbers of 64 bits
    inexact,            ///< an integer beyond 2^53 has no exact double
    not_a_condition,    ///< the value cannot decide a condition
    not_a_number,       ///< a number is needed
    text_not_a_number,  ///< the text does not start with a number
    type_fixed,         ///< the value does not fit the type that the tree's variable has
    no_such_place,  ///< there is no such member or element to write to, or none can be read from
                    ///< undefined
    nested_too_deeply,  ///< arrays and objects nest at most Value::max_depth deep
    no_such_state,      ///< In() of a name that no state has
    no_random           ///< a random number where the host gives none
};

/// 16 bytes. Which fields an operation reads is said in code_ops.def.
struct Instruction {
    CodeOp op;
    bool last : 1;             ///< its target is the result of the expression
    bool tree : 1;             ///< Dialect::tree rules, else Dialect::machine
    std::uint16_t target = 0;  ///< temporary that receives the result
    Operand a;
    Operand b;
    std::uint32_t extra =
        0;  ///< instruction (from the start of the table), row, byte offset or count

    friend bool operator==(const Instruction&, const Instruction&) = default;
};

static_assert(sizeof(Instruction) == 16);

/// While an instruction in [begin, end) fails, evaluation goes on at `handler` instead (isDefined).
struct Guard {
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t handler;

    friend bool operator==(const Guard&, const Guard&) = default;
};

/// A name that stands for a number: in trees an enum constant, which texts may name at run time
/// ('RED' == 1).
struct EnumValue {
    std::string name;
    double value;

    friend bool operator==(const EnumValue&, const EnumValue&) = default;
};

/// All expressions of a program. A CodeId is the first instruction of one; it ends where control
/// reaches an instruction with `last`.
struct CodeTable {
    std::vector<Instruction> instructions;
    std::vector<Value> constants;  ///< the first one is undefined
    std::vector<std::uint32_t>
        offsets;  ///< per instruction: byte of the expression's text that it came from
    std::vector<Guard> guards;      ///< inner ones before outer ones
    std::vector<EnumValue> enums;   ///< sorted by name; filled in by the compiler
    std::uint32_t temporaries = 0;  ///< how many the most demanding expression needs

    friend bool operator==(const CodeTable&, const CodeTable&) = default;
};

/// What a tree's variable accepts; the byte beside its value (EvalContext::entry_types). `missing`:
/// the variable does not exist yet, only := creates it. `any`: made by a script or an untyped port.
/// The others: made by a port or a constant of that type, which then converts texts that scripts
/// assign. All follow BehaviorTree.CPP (exec/evaluate_tree.cpp).
enum class EntryType : std::uint8_t {
    missing,
    any,
    boolean,
    integer,
    unsigned_integer,
    real,
    text
};

/// The name of an operation as in code_ops.def, for example "read_at".
std::string_view name_of(CodeOp op);

/// One line per instruction, readable: "12  greater t0 = t0, s7  last". Constants are printed as
/// values.
std::string dump(const CodeTable& code);

}  // namespace trellis
