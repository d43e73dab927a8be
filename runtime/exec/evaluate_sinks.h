// Where the result of an expression goes: one sink per function of exec/evaluate.h, for both loops
// of evaluate.cpp. accepts() says whether the value is one that the caller can use; `refusal` is
// the failure if it is not. Internal to evaluate.cpp. Covered by tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "exec/evaluate_rules.h"

namespace trellis {

struct ValueSink {
    using Result = bool;
    static constexpr bool forgets = false;
    static constexpr EvalErrorKind refusal = EvalErrorKind::none;
    Value& result;

    static bool accepts(double, bool) { return true; }
    static bool accepts(const Value&, bool) { return true; }
    bool number(double x) { return result.set_real(x), true; }
    bool answer(bool x, bool tree) {
        return tree ? result.set_real(x ? 1 : 0) : result.set_boolean(x), true;
    }
    bool value(const Value& v, bool) { return result = v, true; }
    static bool failure() { return false; }
};

struct NoSink {
    using Result = bool;
    static constexpr bool forgets = true;
    static constexpr EvalErrorKind refusal = EvalErrorKind::none;

    static bool accepts(double, bool) { return true; }
    static bool accepts(const Value&, bool) { return true; }
    static bool number(double) { return true; }
    static bool answer(bool, bool) { return true; }
    static bool value(const Value&, bool) { return true; }
    static bool failure() { return false; }
};

struct ConditionSink {
    using Result = Truth;
    static constexpr bool forgets = false;
    static constexpr EvalErrorKind refusal = EvalErrorKind::not_a_condition;

    static bool accepts(double x, bool tree) { return !tree || !(x < 0); }
    static bool accepts(const Value& v, bool tree) {
        return !tree || tree_condition(v) != Truth::failed;
    }
    static Truth number(double x) { return x != 0 ? Truth::yes : Truth::no; }
    static Truth answer(bool x, bool) { return x ? Truth::yes : Truth::no; }
    static Truth value(const Value& v, bool tree) {
        return tree ? tree_condition(v) : machine_condition(v);
    }
    static Truth failure() { return Truth::failed; }
};

struct RealSink {
    using Result = bool;
    static constexpr bool forgets = false;
    static constexpr EvalErrorKind refusal = EvalErrorKind::not_a_number;
    double& result;

    static bool accepts(double, bool) { return true; }
    static bool accepts(const Value& v, bool) {
        return v.is_number() || v.is(Value::Kind::boolean);
    }
    bool number(double x) { return result = x, true; }
    bool answer(bool x, bool) { return result = x ? 1 : 0, true; }
    bool value(const Value& v, bool) { return result = v.number(), true; }
    static bool failure() { return false; }
};

}  // namespace trellis
