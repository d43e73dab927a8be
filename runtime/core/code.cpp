// Names and the printed form of compiled expressions. Covered by tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#include "core/code.h"

#include <array>

namespace trellis {
namespace {

constexpr std::array op_names = {
#define CODE_OP(name, meaning) std::string_view(#name),
#include "core/code_ops.def"
};

constexpr std::array function_table = {
#define FUNCTION(name, fewest, most, meaning) FunctionInfo{#name, fewest, most, meaning},
#include "core/functions.def"
};

std::string print(Operand operand, const CodeTable& code) {
    switch (operand.space()) {
    case Space::constant:
        return operand.index() < code.constants.size() ? print(code.constants[operand.index()])
                                                       : "-";
    case Space::slot: return std::string(1, 's').append(std::to_string(operand.index()));
    case Space::temporary: return std::string(1, 't').append(std::to_string(operand.index()));
    }
    return {};
}

}  // namespace

std::span<const FunctionInfo> functions() {
    return function_table;
}

std::string_view name_of(CodeOp op) {
    return op_names[static_cast<std::size_t>(op)];
}

std::string dump(const CodeTable& code) {
    std::string out;
    for (std::size_t i = 0; i < code.instructions.size(); ++i) {
        const Instruction& in = code.instructions[i];
        out += std::to_string(i) + "  " + std::string(name_of(in.op)) + " t" +
               std::to_string(in.target) + ", " + print(in.a, code) + ", ";
        out += in.op == CodeOp::call ? std::string(function_table[in.b.index()].name)
                                     : print(in.b, code);
        out += ", " + std::to_string(in.extra);
        if (in.tree) out += "  tree";
        if (in.last) out += "  last";
        out += '\n';
    }
    for (const Guard& g : code.guards) {
        out += "guard " + std::to_string(g.begin) + " to " + std::to_string(g.end) + " else " +
               std::to_string(g.handler) + '\n';
    }
    return out;
}

}  // namespace trellis
