// Leaf types without structs of their own, and their letters.
// SPDX-License-Identifier: MIT
#include "runner/mocks.h"

#include "load/diagnostics.h"
#include "runner/declarations.h"

#include <set>
#include <type_traits>

namespace trellis {

namespace {

bool is_leaf_call(const Row& row) {
    return row.op == Op::action || row.op == Op::condition;
}

}  // namespace

Mocks::Mocks(Program program, bool all)
    : program_(std::move(program)), letters_(program_.rows.size()) {
    for (RowId n{0}; n.index < program_.rows.size(); ++n.index) {
        if (!is_leaf_call(program_.at(n))) { continue; }
        leaves_.push_back(n);
        if (all || is_declared(*program_.call(n).type)) { make_mock(n); }
    }
}

// A copy of the type with the same layout, so that states of the program stay what they are.
void Mocks::make_mock(RowId n) {
    LeafCall& call = program_.calls[program_.at(n).arg];
    if (call.type->tick == &Mocks::tick) { return; }
    LeafType& mock = types_.emplace_back(*call.type);
    mock.tick = &Mocks::tick;
    mock.halt = nullptr;
    call.type = &mock;
}

std::string Mocks::tell(std::string_view name, std::string_view letters) {
    if (letters.empty() || letters.find_first_not_of("SFRK") != std::string_view::npos) {
        return "expected letters of S, F, R and K, found \"" + std::string(letters) + '"';
    }
    std::vector<RowId> found;
    std::vector<std::string_view> known;
    for (const RowId n : leaves_) {
        const std::string_view id = program_.call(n).type->name;
        known.insert(known.end(), {id, program_.name(n)});
        if (id == name || program_.name(n) == name) { found.push_back(n); }
    }
    if (found.empty()) {
        return "there is no leaf \"" + std::string(name) + '"' + suggestion(name, known);
    }
    for (const RowId n : found) {
        const bool at_once = program_.call(n).type->synchronous;
        if (at_once && letters.find('R') != std::string_view::npos) {
            return std::string(program_.name(n)) + " answers at once: it cannot return R";
        }
    }
    for (const RowId n : found) {
        make_mock(n);
        letters_[n.index] = letters;
    }
    return {};
}

std::vector<std::string> Mocks::untold() const {
    std::set<std::string> names;
    for (const RowId n : leaves_) {
        const LeafType& type = *program_.call(n).type;
        if (type.tick == &Mocks::tick && letters_[n.index].empty()) { names.insert(type.name); }
    }
    return {names.begin(), names.end()};
}

Status Mocks::tick(std::byte*, void* object, const Tick&) {
    static_assert(std::is_standard_layout_v<Host>, "leaves are given the address of its robot");
    const Host& host = *static_cast<const Host*>(object);
    const RowId n = *host.leaf;
    const std::string& letters = host.mocks->letters_[n.index];
    if (letters.empty()) {
        const bool at_once = host.mocks->program_.call(n).type->synchronous;
        return at_once ? Status::failure : Status::running;
    }
    switch (letters[(*host.calls)[n.index]++ % letters.size()]) {
    case 'S': return Status::success;
    case 'F': return Status::failure;
    case 'K': return Status::skipped;
    default: return Status::running;
    }
}

}  // namespace trellis
