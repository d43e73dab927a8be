// Lifetimes of leaf structs follow from the tree: a walk over the rows, with a stack of the open
// ones, gives each struct the lowest place that no struct with an overlapping lifetime has.
// SPDX-License-Identifier: MIT
#include "load/leaf_places.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

namespace {

/// Whether at most one child of such a row is between its first and its last tick.
bool takes_turns(Op op) {
    return op == Op::sequence || op == Op::fallback || op == Op::async_sequence ||
           op == Op::async_fallback || op == Op::sequence_with_memory;
}

/// Whether nothing below such a row counts as running once the row does not, and nothing is ticked
/// again that another child could have followed. A leaf that was running and returned SKIPPED does
/// count as running (TREES §1.3): a loop over a queue or a Switch may come back to it much later.
bool leaves_nothing_behind(Op op) {
    switch (op) {
    case Op::reactive_sequence:
    case Op::reactive_fallback:
    case Op::parallel:
    case Op::inverter:
    case Op::force_success:
    case Op::force_failure:
    case Op::repeat:
    case Op::retry:
    case Op::tree:
    case Op::subtree:
    case Op::machine:
    case Op::state:
    case Op::parallel_state:
    case Op::invoke: return true;
    default: return takes_turns(op);
    }
}

/// By row: whether the leaves directly below it may share bytes.
std::vector<bool> sharing_rows(const Program& program) {
    std::vector<bool> shares(program.rows.size());
    for (std::size_t n = 0; n < program.rows.size(); ++n) {
        const Row& row = program.rows[n];
        shares[n] = leaves_nothing_behind(row.op) && (n == 0 || shares[row.parent.index]);
    }
    return shares;
}

/// Whether such a leaf shares bytes. One that can be halted does not: it may have returned SKIPPED,
/// and is halted after others have taken turns.
bool may_share(const LeafType& type) {
    return type.halt == nullptr;
}

std::uint32_t aligned(std::uint32_t place, std::uint32_t align) {
    return (place + align - 1) / align * align;
}

/// Structs as they are on entry, each kept once.
class Prototypes {
public:
    explicit Prototypes(const Program& program)
        : program_(program), slots_(std::bit_ceil(2 * program.calls.size() + 1), none) {}

    /// The place of the call's prototype among those kept.
    std::uint32_t keep(std::uint32_t number) {
        const LeafCall& call = program_.calls[number];
        const std::string_view bytes = bytes_of(call);
        if (bytes.empty()) { return 0; }
        std::size_t at = std::hash<std::string_view>()(bytes) & (slots_.size() - 1);
        for (; slots_[at] != none; at = (at + 1) & (slots_.size() - 1)) {
            const LeafCall& other = program_.calls[slots_[at]];
            if (other.type == call.type && bytes_of(other) == bytes) { return places_[at]; }
        }
        if (places_.empty()) { places_.resize(slots_.size()); }
        slots_[at] = number;
        places_[at] = static_cast<std::uint32_t>(kept_.size());
        const auto* const first = program_.prototypes.data() + call.prototype;
        kept_.insert(kept_.end(), first, first + call.fresh_size);
        return places_[at];
    }
    std::vector<std::byte> take() { return std::move(kept_); }

private:
    static constexpr std::uint32_t none = 0xffffffff;

    std::string_view bytes_of(const LeafCall& call) const {
        const std::byte* const first = program_.prototypes.data() + call.prototype;
        return {reinterpret_cast<const char*>(first), call.fresh_size};
    }

    const Program& program_;
    std::vector<std::uint32_t> slots_;   // a hash table of calls
    std::vector<std::uint32_t> places_;  // by slot
    std::vector<std::byte> kept_;
};

void share_prototypes(Program& program) {
    Prototypes kept(program);
    std::vector<std::uint32_t> places;
    places.reserve(program.calls.size());
    for (std::uint32_t i = 0; i < program.calls.size(); ++i) {
        places.push_back(kept.keep(i));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        program.calls[i].prototype = places[i];
    }
    program.prototypes = kept.take();
    program.prototypes.shrink_to_fit();
}

/// A row whose subtree is being walked.
struct OpenRow {
    RowId end;
    bool turns;
    std::uint32_t begin;  ///< bytes before it
    std::uint32_t taken;  ///< as far as any struct below it reaches
};

constexpr std::uint32_t no_place = 0xffffffff;

/// The leaves that share no bytes with others that run come first, each at a place of its own; all
/// that answer at once have the first bytes. Returns the bytes they take. The others get no place.
std::uint32_t place_alone(Program& program, const std::vector<bool>& shares) {
    std::uint32_t taken = 0;
    for (const LeafCall& call : program.calls) {
        if (call.type->synchronous) { taken = std::max(taken, call.type->size); }
    }
    for (const Row& row : program.rows) {
        if (row.op != Op::action && row.op != Op::condition) { continue; }
        LeafCall& call = program.calls[row.arg];
        if (call.type->synchronous) {
            call.offset = 0;
        } else if (may_share(*call.type) && shares[row.parent.index]) {
            call.offset = no_place;
        } else {
            call.offset = aligned(taken, call.type->align);
            taken = call.offset + call.type->size;
        }
    }
    return taken;
}

}  // namespace

void place_leaves(Program& program) {
    std::uint32_t taken = place_alone(program, sharing_rows(program));
    std::vector<OpenRow> open{{RowId(), false, taken, taken}};
    for (std::uint32_t n = 0; n < program.rows.size(); ++n) {
        while (open.back().end.index <= n) {
            taken = open.back().taken;
            open.pop_back();
            open.back().taken = std::max(open.back().taken, taken);
        }
        const Row& row = program.rows[n];
        OpenRow& parent = open.back();
        const std::uint32_t begin = parent.turns ? parent.begin : parent.taken;
        if (row.op != Op::action && row.op != Op::condition) {
            open.push_back({row.end, takes_turns(row.op), begin, begin});
            continue;
        }
        LeafCall& call = program.calls[row.arg];
        if (call.offset != no_place) { continue; }
        call.offset = aligned(begin, call.type->align);
        parent.taken = std::max(parent.taken, call.offset + call.type->size);
    }
    for (const OpenRow& row : open) {
        program.leaf_bytes = std::max(program.leaf_bytes, row.taken);
    }
    share_prototypes(program);
}

}  // namespace trellis
