// Claims of variable_types.h, and which of them clash.
// SPDX-License-Identifier: MIT
#include "load/variable_types.h"

#include "core/number.h"
#include "load/builder.h"
#include "load/text.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace trellis {

namespace {

/// A text that messages show whole.
constexpr std::size_t longest_shown = 40;  // bytes

bool is_number_type(PortType type) {
    return type != PortType::any && type != PortType::text;
}

auto order(Where where) {
    return std::tuple(where.file, where.line, where.column);
}

}  // namespace

VariableTypes::First& VariableTypes::first(SlotId slot) {
    if (slot.index >= firsts_.size()) { firsts_.resize(slot.index + 1); }
    return firsts_[slot.index];
}

void VariableTypes::bound(SlotId slot, PortType type, Where where) {
    if (type == PortType::any) { return; }
    const Claim claim{.slot = slot, .where = where, .type = type};
    claims_.push_back(claim);
    First& before = first(slot);
    if (before.type == PortType::any) { before = {.type = type, .where = where}; }
    if (before.type == type || before.type == PortType::text) { return; }
    before.refused = true;
    builder_.diagnostics().error(
        "type-clash", where,
        message(claim, {.slot = slot, .where = before.where, .type = before.type}));
}

void VariableTypes::begins(SlotId slot, const Value& value, Where where) {
    PortType type = PortType::text;
    if (value.is(Value::Kind::text)) {
        claim_text(slot, Claim::Kind::first_text, value.as_text(), where);
    } else if (value.is_number()) {
        claims_.push_back({.slot = slot, .where = where, .kind = Claim::Kind::number});
        const bool whole = value.is(Value::Kind::integer);
        const bool small =
            whole && value.as_integer() == static_cast<std::int32_t>(value.as_integer());
        type = small ? PortType::int32 : whole ? PortType::int64 : PortType::real;
    } else {
        return;
    }
    first(slot) = {.type = type, .where = where};
}

void VariableTypes::given(SlotId slot, const Value& value, Where where) {
    if (value.is_number()) {
        claims_.push_back({.slot = slot, .where = where, .kind = Claim::Kind::number});
    } else if (value.is(Value::Kind::text) && !may_be_number(value.as_text())) {
        claim_text(slot, Claim::Kind::text, value.as_text(), where);
    }
}

void VariableTypes::claim_text(SlotId slot, Claim::Kind kind, std::string_view text, Where where) {
    claims_.push_back({.slot = slot,
                       .where = where,
                       .kind = kind,
                       .text = static_cast<std::uint32_t>(texts_.size())});
    texts_.emplace_back(text);
}

// Whether the text is converted where a number is wanted: by what it begins with, or by name.
bool VariableTypes::may_be_number(std::string_view text) const {
    for (const std::string_view name : {"true", "True", "TRUE", "false", "False", "FALSE"}) {
        if (text == name) { return true; }
    }
    return parse_number(text).length != 0 || builder_.enumerated(text).is(Value::Kind::integer);
}

// Comparing ---------------------------------------------------------------------------------------

void VariableTypes::report() {
    std::stable_sort(claims_.begin(), claims_.end(), [](const Claim& a, const Claim& b) {
        return std::tuple(a.slot, order(a.where)) < std::tuple(b.slot, order(b.where));
    });
    for (auto begin = claims_.cbegin(); begin != claims_.cend();) {
        const auto end = std::find_if(
            begin, claims_.cend(), [&](const Claim& claim) { return claim.slot != begin->slot; });
        compare_ports(begin, end);
        compare_values(begin, end);
        begin = end;
    }
}

// Ports of several types, where the text is first: it is converted each time, if it can be.
void VariableTypes::compare_ports(Claims begin, Claims end) {
    if (first(begin->slot).refused) { return; }
    std::vector<Claims> types;  // the first port of each
    for (Claims claim = begin; claim != end; ++claim) {
        if (claim->kind != Claim::Kind::port) { continue; }
        const bool known = std::any_of(types.begin(), types.end(),
                                       [&](Claims other) { return other->type == claim->type; });
        if (!known) { types.push_back(claim); }
    }
    for (std::size_t i = 1; i < types.size(); ++i) {
        clash(*types[i], *types[0]);
    }
}

// A text that spells no number is not stored where a port or a script has put a number, nor read
// by a port that takes numbers; a number is not stored where a SubTree has put a text.
void VariableTypes::compare_values(Claims begin, Claims end) {
    const auto find = [&](auto is_wanted) { return std::find_if(begin, end, is_wanted); };
    const Claims port = find([](const Claim& claim) {
        return claim.kind == Claim::Kind::port && is_number_type(claim.type);
    });
    const Claims number =
        find([](const Claim& claim) { return claim.kind == Claim::Kind::number; });
    for (Claims claim = begin; claim != end; ++claim) {
        const bool first = claim->kind == Claim::Kind::first_text;
        if (!first && claim->kind != Claim::Kind::text) { continue; }
        if (port != end && (!first || !may_be_number(texts_[claim->text]))) {
            clash(*claim, *port);
        } else if (number != end) {
            first ? clash(*number, *claim) : clash(*claim, *number);
        }
    }
}

void VariableTypes::clash(const Claim& here, const Claim& there) {
    // a subtree is compiled wherever it is used, and says the same each time
    const std::uint64_t at = (std::uint64_t{here.where.file} << 48U) ^
                             (std::uint64_t{here.where.line} << 20U) ^ here.where.column;
    if (!reported_.insert(at).second) { return; }
    builder_.diagnostics().warning("type-clash", here.where, message(here, there));
}

// Words -------------------------------------------------------------------------------------------

std::string VariableTypes::message(const Claim& here, const Claim& there) const {
    std::string text = '"' + builder_.program.slots[here.slot.index].name + "\" is " + words(here) +
                       " here, but " + words(there) + " in ";
    if (there.where.file != here.where.file) {
        text += std::string(builder_.diagnostics().file_name(there.where.file)) + ", ";
    }
    return text + "line " + std::to_string(there.where.line);
}

std::string VariableTypes::words(const Claim& claim) const {
    if (claim.kind == Claim::Kind::port) { return std::string(name_of(claim.type)); }
    if (claim.kind == Claim::Kind::number) { return "a number"; }
    const std::string& text = texts_[claim.text];
    return text.size() <= longest_shown ? "the text " + quoted(text) : "a text";
}

}  // namespace trellis
