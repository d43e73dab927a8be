// Widths, characters that cannot be shown, line breaks.
// SPDX-License-Identifier: MIT
#include "runner/drawing/lettering.h"

#include <doctest/doctest.h>

using namespace trellis::drawing;

TEST_CASE("lettering: wider letters, larger sizes and bold are wider") {
    CHECK(text_width("iii", Lettering::detail) < text_width("mmm", Lettering::detail));
    CHECK(text_width("abc", Lettering::detail) < text_width("abc", Lettering::title));
    CHECK(text_width("日", Lettering::detail) > text_width("é", Lettering::detail));
    CHECK(text_width("", Lettering::title) == 0);
    CHECK(text_width("m", Lettering::title) == doctest::Approx(13 * 1.042));
}

TEST_CASE("lettering: what would not be seen is shown") {
    CHECK(visible("a\nb\x01") == "a␊b␁");
    CHECK(visible("\x7F") == "␡");
    CHECK(visible("a\xE2\x80\xAE") == "a⟨U+202E⟩");
    CHECK(visible("\xC2\x85") == "⟨U+0085⟩");
    CHECK(visible("é日😀") == "é日😀");
    CHECK(visible("\xFF\xC3") == "��");
    CHECK(visible("\xED\xA0\x80") == "���");  // a surrogate
    CHECK(visible_line("  a \n\t b ") == "a b");
    CHECK(visible_line(" \n").empty());
    CHECK(ascii_only("é日") == "\\u{e9}\\u{65e5}");
}

TEST_CASE("lettering: long texts are cut between letters and broken at spaces") {
    CHECK(shortened("äöüß", 4) == "äöüß");
    CHECK(shortened("äöüß", 3) == "äö…");
    CHECK(shortened("ab", 0) == "…");
    CHECK(wrapped("one two three", 8, 3) == std::vector<std::string>{"one two", "three"});
    CHECK(wrapped("abcdefghij", 4, 2) == std::vector<std::string>{"abcd", "efg…"});
    CHECK(wrapped("a bcdefgh", 6, 9) == std::vector<std::string>{"a bcde", "fgh"});
    CHECK(wrapped("", 6, 2) == std::vector<std::string>{""});
}
