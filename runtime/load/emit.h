// Syntax → code: names become slots, rows, offsets and constants. Everything that can be known is
// found here; what only goes wrong if it is reached (an undeclared variable of a machine, `5 := 1`
// in a tree) becomes a `fail` instruction, because SCXML and BehaviorTree.CPP load such documents.
// Evaluates nothing but arithmetic on literals. Covered by tests/load/expression_test.cpp and
// tests/exec/evaluate_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/code.h"
#include "core/ids.h"
#include "core/value.h"
#include "load/expression.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trellis {

/// What the compiler knows about a name.
struct Meaning {
    enum class Kind : std::uint8_t {
        slot,            ///< variable `index`
        read_only_slot,  ///< the same, but assigning to it fails when it is reached (_event,
                         ///< _sessionid)
        constant,        ///< `value` (an enum number)
        sensor_boolean,  ///< the host's bool at byte `index`
        sensor_integer,  ///< the host's std::int32_t at byte `index`
        sensor_real,     ///< the host's double at byte `index`
        elapsed_count,   ///< time: row_memory[index] cycles
        elapsed_since,   ///< time since cycle row_memory[index]
        state,           ///< state of row `index`
        undeclared,      ///< nothing: fails when it is reached
        error            ///< nothing, and `message` is reported now
    };

    Kind kind = Kind::undeclared;
    std::uint32_t index = 0;
    Value value = {};          ///< of a constant
    std::string message = {};  ///< of an error
};

/// What a name is looked up for. create: left of := in a tree.
enum class Use : std::uint8_t { read, write, create };

/// What an expression can see: implemented by the compiler (and by tests), asked once per use of a
/// name.
class Names {
public:
    /// The variable or constant `name`. In trees a slot should be given for every name that
    /// anything in the file may write, and for `create` always; `undeclared` makes reading fail,
    /// except that an undeclared `pi` is π.
    virtual Meaning variable(std::string_view name, Use use) = 0;

    /// In trees: variable `slot` is given this value, or an unknown number, at byte `offset` of the
    /// text. Said only if the text alone tells.
    virtual void assigned(std::uint32_t slot, const Value& value, std::uint32_t offset) {
        static_cast<void>(slot), static_cast<void>(value), static_cast<void>(offset);
    }

    /// The sensor that expressions call _x.NAME; `undeclared` makes it a member of the variable _x.
    virtual Meaning sensor(std::string_view name) = 0;

    /// What elapsed() counts here: elapsed_count, elapsed_since or error.
    virtual Meaning elapsed() = 0;

    /// The state `name` of In('name'): state, undeclared (fails when it is reached) or error.
    virtual Meaning state(std::string_view name) = 0;

protected:
    ~Names() = default;
};

/// One fault, at byte `offset` of the text.
struct EmitError {
    std::uint32_t offset = 0;
    std::string message = {};
};

/// Appends the code of `syntax` to `code`. No id, and `errors` longer, if it has faults; `code` is
/// then to be thrown away.
CodeId emit(const Syntax& syntax, Names& names, CodeTable& code, std::vector<EmitError>& errors);

/// Machines: code that writes what EvalContext::temporaries[stored_temporary] holds before the
/// evaluation to `location` (SyntaxMode::location).
CodeId emit_store(const Syntax& location, Names& names, CodeTable& code,
                  std::vector<EmitError>& errors);

}  // namespace trellis
