// The one pass that turns syntax into code: children before their parents, temporaries used like a
// stack. An operand is used where it lies (a constant, a variable, a temporary); it is copied first
// only where an assignment to its right could change it. Code only jumps forward. Internal to
// emit.cpp (values and operators), emit_names.cpp (names, places, calls) and emit_code.cpp (single
// instructions). Covered by tests/load/expression_test.cpp and tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/emit.h"

#include <cstddef>
#include <optional>
#include <span>

namespace trellis {

class Emitter {
public:
    Emitter(const Syntax& syntax, Names& names, CodeTable& code, std::vector<EmitError>& errors)
        : syntax_(syntax), names_(names), code_(code), errors_(errors),
          faults_before_(errors.size()), first_constant_(code.constants.size()),
          begin_(position()) {
        if (code.constants.empty()) code.constants.emplace_back();  // no_operand
    }

    /// The code of a whole expression or script; no id if there are faults.
    CodeId whole();

    /// The code that stores temporaries[stored_temporary]; no id if there are faults.
    CodeId store();

private:
    static constexpr std::uint32_t first_temporary = accumulator_operand.index() + 1;
    static_assert(stored_temporary == first_temporary);

    const SyntaxNode& node(std::uint32_t n) const { return syntax_.nodes[n]; }
    std::uint32_t child(std::uint32_t n, std::uint32_t i) const {
        return syntax_.children[node(n).first + i];
    }
    bool tree() const { return syntax_.dialect == Dialect::tree; }
    std::uint32_t position() const { return static_cast<std::uint32_t>(code_.instructions.size()); }
    CodeId finished(CodeId id) const { return errors_.size() == faults_before_ ? id : CodeId(); }
    void report(std::uint32_t n, std::string message);
    std::uint32_t temporary();

    // ---- single instructions ----
    std::uint32_t add(std::uint32_t n, Instruction in);
    // the operations that take numbers, or at least compute with them where they get them
    static bool reads_number(const Instruction& in);
    // Gives the previous instruction the accumulator as its target, if that is where `operand`
    // comes from and it can only be a number.
    Operand accumulated(Operand operand);
    bool gives_number(const Instruction& in) const;
    bool is_number(Operand operand) const;
    struct Parts {
        Operand a = {};
        Operand b = {};
        std::uint32_t extra = 0;
    };

    std::uint32_t add(std::uint32_t n, CodeOp op, std::uint32_t target, bool last, Parts parts);
    void land(std::uint32_t jump);
    void fail(std::uint32_t n, EvalErrorKind kind, std::string_view name);
    Operand constant(Value value);
    const Value* constant_at(Operand operand) const;

    // ---- values ----
    // where the value of `n` lies; code that computes it if it does not lie anywhere yet
    Operand value(std::uint32_t n);
    // the same, safe from assignments in code that follows
    Operand stable_value(std::uint32_t n, bool assigned_later);
    // a number that the syntax alone determines, exactly as evaluation would compute it
    std::optional<double> fold(std::uint32_t n) const;
    // integers among the constants become what the operator makes of them
    Operand as_double(CodeOp op, Operand operand);
    // code that puts the value of `n` into temporary `t`; `last`: and ends the expression
    void into(std::uint32_t n, std::uint32_t t, bool last);
    void sequence(std::uint32_t n, std::uint32_t result);
    Meaning variable(std::uint32_t n, Use use);
    // what `meaning` stands for, into `t`
    void read(std::uint32_t n, const Meaning& meaning, std::string_view name, std::uint32_t t,
              bool last);
    void path(std::uint32_t n, std::uint32_t t, bool last);
    // of _x.NAME and _x['NAME']
    std::optional<Meaning> sensor_of(std::uint32_t n);
    // the values of `nodes` beside each other: constants if all of them are, else temporaries; the
    // first one's place
    Operand run(std::span<const std::uint32_t> nodes);
    // into(), by way of a constant if the value is known
    void into_whole(std::uint32_t n, std::uint32_t t);
    void operation(std::uint32_t n, std::uint32_t t, bool last);
    // machines: the truth of `n`
    void boolean_into(std::uint32_t n, std::uint32_t t, bool last);
    // trees: operand by operand, until one comparison is false
    void comparisons(std::uint32_t n, std::uint32_t t, bool last);
    void conditional(std::uint32_t n, std::uint32_t t, bool last);

    // ---- assignments ----
    void assignment(std::uint32_t n, std::uint32_t t, bool last);
    // writes `value` (temporaries[t] below variables) to `place` and leaves it in t
    void write(std::uint32_t place, Operand value, std::uint32_t t, bool last);
    // BehaviorTree.CPP: := creates the entry before it evaluates the right-hand side, the others
    // ask for it
    void tree_assignment(std::uint32_t n, std::uint32_t t, bool last);
    // for Names::assigned()
    void tell_assigned(std::uint32_t place, std::uint32_t slot, CodeOp op, std::uint32_t right,
                       Operand given);

    // ---- calls ----
    void call(std::uint32_t n, std::uint32_t t, bool last);
    bool takes(std::uint32_t n, std::string_view name, std::uint8_t fewest, std::uint8_t most);
    // In('s'), and In(s) where s is no variable (the null data model)
    void in_state(std::uint32_t n, std::uint32_t t, bool last);
    // whatever fails in the argument makes it undefined
    void is_defined(std::uint32_t n, std::uint32_t t, bool last);

    const Syntax& syntax_;
    Names& names_;
    CodeTable& code_;
    std::vector<EmitError>& errors_;
    std::size_t faults_before_;
    std::size_t first_constant_;
    std::uint32_t begin_;      // first instruction of the expression
    bool read_again_ = false;  // the operands of this instruction are not used up
    std::uint32_t landed_at_ = Id<CodeTag>::none;  // where a jump went last
    std::uint32_t next_temporary_ = first_temporary;
};

}  // namespace trellis
