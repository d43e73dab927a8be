// Behaviour files in JSON, in and out of a Document. A tree file and a machine file are spelt
// differently, so every function is told or guesses the kind. What the names mean is not known here
// (grammar.h). Covered by tests/load/json_trees_test.cpp and json_machines_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"
#include "load/json_tree.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trellis {

/// The kind of file that the members of the outermost object tell: "trees" or "BTCPP_format" of a
/// tree file, "states", "initial" or "datamodel" of a machine; none if there are none of them.
std::optional<FileKind> json_kind(const JsonTree& json);

/// The document that `json` spells, equal (same_content) to the one of the XML file that says the
/// same, with places in the JSON text. None if a value is not of the type that its member takes, a
/// member is missing or of no use, or a name cannot be written in XML: structural errors
/// "json-type", "json-member" and "bad-name"; "too-large" beyond the limits.
std::optional<Document> document_from_json(const JsonTree& json, FileKind kind,
                                           Diagnostics& diagnostics,
                                           const DocumentLimits& limits = {});

/// parse_json(), then document_from_json().
std::optional<Document> read_json(std::string_view text, std::uint32_t file, FileKind kind,
                                  Diagnostics& diagnostics, const DocumentLimits& limits = {});

/// The document as JSON; read_json() gives canonical(document, kind) again. The root must be the
/// one that files of this kind have: file_kind(document) == kind.
std::string write_json(const Document& document, FileKind kind);

/// The document in the form to which its way through JSON brings it; its own canonical form. Only
/// what means nothing differs: the order between children of different kinds (JSON has one array
/// per kind: include, tree, model; data, script, onentry, …, state), several <datamodel> in one
/// state or several plain <TreeNodesModel> become one, a comment before something that JSON writes
/// as an array moves to the first thing inside, and the root <scxml> (no other) declares SCXML's
/// namespace.
Document canonical(const Document& document, FileKind kind);

}  // namespace trellis
