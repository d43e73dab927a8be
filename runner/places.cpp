// Places in the text, sorted.
// SPDX-License-Identifier: MIT
#include "runner/places.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace trellis {

Places::Places(const Program& program, const Document& document, std::uint32_t file)
    : program_(&program), document_(&document), elements_(program.rows.size()) {
    using Spot = std::pair<std::uint64_t, std::uint32_t>;  // line and column, element
    const auto key = [](std::uint32_t line, std::uint32_t column) {
        return std::uint64_t{line} << 32 | column;
    };
    std::vector<Spot> places;
    for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
        const Where& where = document.elements[i].where;
        places.emplace_back(key(where.line, where.column), i);
    }
    std::sort(places.begin(), places.end());
    for (std::uint32_t i = 0; i < program.rows.size(); ++i) {
        const Origin& origin = program.origins[i];
        if (origin.file != file || origin.line == 0) { continue; }
        const std::uint64_t wanted = key(origin.line, origin.column);
        const auto found = std::lower_bound(places.begin(), places.end(), Spot{wanted, 0});
        if (found != places.end() && found->first == wanted) { elements_[i] = {found->second}; }
    }
}

ElementId Places::of(TransitionId transition) const {
    const RowId source = program_->transitions[transition.index].source;
    const StateInfo& info = program_->state(source);
    const ElementId state = of(source);
    if (!state || transition.index < info.first_transition) { return {}; }
    std::uint32_t before = transition.index - info.first_transition;
    for (const ElementId child : document_->children(state)) {
        if (document_->name(child) == "transition" && before-- == 0) { return child; }
    }
    return {};
}

}  // namespace trellis
