// Reads and checks a text. Covered by tests/load/faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "support/diagnose.h"

#include "load/check.h"
#include "load/grammar.h"
#include "load/json.h"
#include "load/xml.h"

#include <optional>

namespace trellis::test {

Findings diagnose(const std::string& name, std::string_view text, const Registry& registry) {
    Findings out;
    const std::uint32_t file = out.diagnostics.add_file(name, text);
    std::optional<Document> document;
    if (name.ends_with(".json")) {
        if (const auto json = parse_json(text, file, out.diagnostics)) {
            out.kind = json_kind(*json).value_or(FileKind::tree);
            document = document_from_json(*json, out.kind, out.diagnostics);
        }
    } else if ((document = read_xml(text, file, out.diagnostics))) {
        const bool machine =
            closest(document->name(document->root()), {"root", "scxml"}) == "scxml";
        out.kind = file_kind(*document).value_or(machine ? FileKind::machine : FileKind::tree);
    }
    if (document) {
        out.readable = true;
        const bool machine = out.kind == FileKind::machine;
        check(*document, machine ? machine_grammar() : tree_grammar(registry), out.diagnostics);
    }
    out.diagnostics.sort();
    return out;
}

}  // namespace trellis::test
