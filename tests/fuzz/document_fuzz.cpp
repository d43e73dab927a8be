// Property: whatever the bytes, reading them ends, and what can be read is written and read again
// without loss, in XML and in JSON: read(write(read(x))) == read(x).
// SPDX-License-Identifier: MIT
#include "load/check.h"
#include "load/json.h"
#include "load/load.h"
#include "load/xml.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace trellis;
    const std::string text(reinterpret_cast<const char*>(data), size);
    Diagnostics diagnostics;
    const std::optional<Document> document = read({.name = "fuzz", .text = text}, diagnostics);
    static_cast<void>(diagnostics.render());
    if (!document) { return 0; }

    Diagnostics none;
    const std::optional<Document> again = read_xml(write_xml(*document), 0, none);
    if (!again || !same_content(*document, *again)) { std::abort(); }

    const std::optional<FileKind> kind = file_kind(*document);
    if (!kind) { return 0; }
    const Document canonic = canonical(*document, *kind);
    const std::optional<Document> from_json =
        read_json(write_json(*document, *kind), 0, *kind, none);
    if (!from_json || !same_content(canonic, *from_json)) { std::abort(); }
    return 0;
}
