// What the nodes of a whole program take each variable for: the types of the ports it is bound to,
// the texts and numbers that scripts and literals give it. A variable is the same one wherever
// remaps lead to it, so what one tree writes is held against what another reads. Private to
// runtime/load. Covered by tests/load/variable_types_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/ids.h"
#include "core/leaf.h"
#include "core/value.h"
#include "load/diagnostics.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace trellis {

class Builder;

class VariableTypes {
public:
    explicit VariableTypes(Builder& builder) : builder_(builder) {}

    /// A port of type `type` is bound to the variable. An error if BehaviorTree.CPP refuses that
    /// when loading: if the first that was bound is of another type, and no text, which is
    /// converted (TREES §2.1).
    void bound(SlotId slot, PortType type, Where where);
    /// The variable begins with this value, a literal of a SubTree.
    void begins(SlotId slot, const Value& value, Where where);
    /// A script, or a node, gives the variable this value, or an unknown one of its kind.
    void given(SlotId slot, const Value& value, Where where);

    /// To be called once all is compiled: warnings for what clashes if it is ever ticked. They do
    /// not depend on the order in which the nodes were compiled.
    void report();

private:
    /// What one place says of a variable.
    struct Claim {
        enum class Kind : std::uint8_t {
            port,       ///< of type `type`
            number,     ///< is given
            text,       ///< no number: is given
            first_text  ///< a literal of a SubTree, which may spell a number
        };
        SlotId slot;
        Where where;
        Kind kind = Kind::port;
        PortType type = PortType::any;
        std::uint32_t text = 0;  ///< index into texts_
    };
    /// What was bound to a variable first.
    struct First {
        PortType type = PortType::any;
        Where where;
        bool refused = false;  ///< another type was, since: the error is reported
    };
    using Claims = std::vector<Claim>::const_iterator;

    void claim_text(SlotId slot, Claim::Kind kind, std::string_view text, Where where);
    bool may_be_number(std::string_view text) const;
    First& first(SlotId slot);
    void compare_ports(Claims begin, Claims end);
    void compare_values(Claims begin, Claims end);
    void clash(const Claim& here, const Claim& there);
    std::string message(const Claim& here, const Claim& there) const;
    std::string words(const Claim& claim) const;

    Builder& builder_;
    std::vector<First> firsts_;  // by slot
    std::vector<Claim> claims_;
    std::vector<std::string> texts_;
    std::unordered_set<std::uint64_t> reported_;  // places
};

}  // namespace trellis
