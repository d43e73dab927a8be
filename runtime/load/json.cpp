// Which mapping a file takes, and the way from text through it and back. Covered by
// tests/load/json_trees_test.cpp and json_machines_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/json.h"

#include "load/json_mapping.h"

#include <cassert>
#include <limits>
#include <utility>

namespace trellis {

std::optional<FileKind> json_kind(const JsonTree& json) {
    for (const std::string_view key : {"trees", "BTCPP_format"}) {
        if (json.member(json.root(), key)) { return FileKind::tree; }
    }
    for (const std::string_view key : {"states", "initial", "datamodel"}) {
        if (json.member(json.root(), key)) { return FileKind::machine; }
    }
    return std::nullopt;
}

std::optional<Document> document_from_json(const JsonTree& json, FileKind kind,
                                           Diagnostics& diagnostics, const DocumentLimits& limits) {
    switch (kind) {
    case FileKind::tree: return tree_from_json(json, diagnostics, limits);
    case FileKind::machine: return machine_from_json(json, diagnostics, limits);
    }
    return std::nullopt;
}

std::optional<Document> read_json(std::string_view text, std::uint32_t file, FileKind kind,
                                  Diagnostics& diagnostics, const DocumentLimits& limits) {
    const auto json = parse_json(text, file, diagnostics, limits);
    if (!json) { return std::nullopt; }
    return document_from_json(*json, kind, diagnostics, limits);
}

namespace {

JsonTree to_json(const Document& document, FileKind kind) {
    assert(file_kind(document) == kind);
    return kind == FileKind::tree ? tree_to_json(document) : machine_to_json(document);
}

}  // namespace

std::string write_json(const Document& document, FileKind kind) {
    return print_json(to_json(document, kind));
}

Document canonical(const Document& document, FileKind kind) {
    // whatever was read before may be read again: only the text of a file is limited
    constexpr std::uint32_t any = std::numeric_limits<std::int32_t>::max();
    Diagnostics diagnostics;
    auto back = document_from_json(to_json(document, kind), kind, diagnostics,
                                   {.depth = any, .elements = any});
    assert(back);
    return *std::move(back);
}

}  // namespace trellis
