// Where the XML reader is in its text, with the small steps that its parts share, and the XML
// declaration. Included by xml.cpp and xml_cursor.cpp only. Covered by tests/load/xml_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/diagnostics.h"
#include "load/text.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trellis {

struct XmlCursor {
    XmlCursor(std::string_view source, std::uint32_t file, Diagnostics& to)
        : text(source), lines(source, file), diagnostics(to) {}

    std::string_view text;
    std::size_t at = 0;
    LineCounter lines;
    Diagnostics& diagnostics;

    std::string_view rest() const { return text.substr(at); }
    bool ahead(std::string_view s) const { return rest().starts_with(s); }

    /// Passes blanks; whether there were any.
    bool skip_blanks();
    /// Passes a name; empty if there is none.
    std::string_view take_name();
    /// A value as written, without its quotes.
    struct RawValue {
        std::string_view text;
        bool plain = true;  ///< it stands for itself: no "&" and no carriage return in it
    };
    /// Passes the rest of `name = "value"`; none and an error if it is wrong.
    std::optional<RawValue> take_value(std::string_view name);
    /// Passes the XML declaration, if there is one; false and an error if it is wrong.
    bool take_declaration();

    /// Each makes an error and returns false: of that id at an offset; "xml-syntax" here; "expected
    /// …, found …" here.
    bool fail(const char* id, std::size_t offset, std::string message);
    bool fail_syntax(std::string message);
    bool fail_expected(std::string_view what);

private:
    /// `name = "value"` of the declaration.
    struct Declared {
        bool ok = true;  ///< false after an error
        bool given = false;
        std::string_view value;
    };
    Declared take_declared(std::string_view name);
};

}  // namespace trellis
