// Rendering, ordering and counting of findings, and suggestions for misspelt names.
// SPDX-License-Identifier: MIT
#include "load/diagnostics.h"

#include <doctest/doctest.h>

#include <string>

using namespace trellis;

namespace {

std::string rendered(std::string_view text, std::uint32_t line, std::uint32_t column) {
    Diagnostics d;
    d.add_file("f.xml", text);
    d.error("some-id", {0, line, column}, "what is wrong");
    return d.render(d.all()[0]);
}

}  // namespace

TEST_CASE("diagnostics: render shows the place, the line and a caret") {
    Diagnostics d;
    d.add_file("trees/cover.xml",
               "<Repeat>\n  <Clear/>\n  <MoveForward speed=\"fast\"/>\n</Repeat>\n");
    d.error("not-a-number", {0, 3, 23}, "expected a number in m/s, found \"fast\"");
    CHECK_FALSE(d.ok());
    CHECK(d.render(d.all()[0]) ==
          "trees/cover.xml:3:23: error: expected a number in m/s, found \"fast\" [not-a-number]\n"
          "  <MoveForward speed=\"fast\"/>\n"
          "                      ^\n");
}

TEST_CASE("diagnostics: a finding names the file it is about") {
    Diagnostics d;
    CHECK(d.add_file("main.xml", "<a/>") == 0);
    CHECK(d.add_file("escape.xml", "<b/>\n") == 1);
    CHECK(d.file_name(1) == "escape.xml");
    CHECK(d.file_name(2) == "");
    d.warning("w", {1, 1, 2}, "odd");
    CHECK(d.render(d.all()[0]) == "escape.xml:1:2: warning: odd [w]\n<b/>\n ^\n");
}

TEST_CASE("diagnostics: a finding without a place shows no line") {
    CHECK(rendered("<a/>", 0, 0) == "f.xml: error: what is wrong [some-id]\n");
    Diagnostics d;
    d.error("some-id", {}, "what is wrong");
    CHECK(d.render(d.all()[0]) == "error: what is wrong [some-id]\n");
}

TEST_CASE("diagnostics: the caret stands below its character after tabs and UTF-8") {
    CHECK(rendered("\ta\t<b/>\r\n", 1, 5) ==
          "f.xml:1:5: error: what is wrong [some-id]\n\ta\t<b/>\n\t \t ^\n");
    CHECK(rendered("é=€x", 1, 7) == "f.xml:1:7: error: what is wrong [some-id]\né=€x\n   ^\n");
}

TEST_CASE("diagnostics: a caret may stand behind the end of the line or of the text") {
    CHECK(rendered("ab\ncd", 1, 3) == "f.xml:1:3: error: what is wrong [some-id]\nab\n  ^\n");
    CHECK(rendered("ab\n", 2, 1) == "f.xml:2:1: error: what is wrong [some-id]\n\n^\n");
    CHECK(rendered("ab\n", 1, 99) == "f.xml:1:99: error: what is wrong [some-id]\nab\n  ^\n");
    CHECK(rendered("ab\n", 7, 1) == "f.xml:7:1: error: what is wrong [some-id]\n");
}

TEST_CASE("diagnostics: a long line is cut around the place") {
    const std::string left(200, 'l');
    const std::string right(200, 'r');
    CHECK(rendered(left + "X" + right, 1, 201) ==
          "f.xml:1:201: error: what is wrong [some-id]\n…" + std::string(60, 'l') + "X" +
              std::string(59, 'r') + "…\n" + std::string(61, ' ') + "^\n");
    CHECK(rendered("X" + right, 1, 1) ==
          "f.xml:1:1: error: what is wrong [some-id]\nX" + std::string(119, 'r') + "…\n^\n");
    CHECK(rendered(left + "X", 1, 201) == "f.xml:1:201: error: what is wrong [some-id]\n…" +
                                              std::string(119, 'l') + "X\n" +
                                              std::string(120, ' ') + "^\n");
}

TEST_CASE("diagnostics: a cut never splits a character") {
    std::string line;
    for (int i = 0; i < 100; ++i) {
        line += "é";
    }
    line += "X";
    const std::string out = rendered(line, 1, 201);
    CHECK(out.find("…é") != std::string::npos);
    CHECK(out.ends_with("éX\n" + std::string(61, ' ') + "^\n"));
}

TEST_CASE("diagnostics: all of them end with a line that counts") {
    Diagnostics d;
    CHECK(d.render() == "");
    d.add_file("f", "x\n");
    d.warning("w", {}, "odd");
    CHECK(d.ok());
    CHECK(d.render() == "f: warning: odd [w]\n1 warning\n");
    d.error("e", {}, "bad");
    d.error("e", {}, "worse");
    CHECK(d.errors() == 2);
    CHECK(d.render() == "f: warning: odd [w]\nf: error: bad [e]\nf: error: worse [e]\n"
                        "2 errors, 1 warning\n");
}

TEST_CASE("diagnostics: a thousand errors and a thousand warnings are kept, and that is said") {
    Diagnostics d;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        d.warning("w", {0, i + 1, 1}, "odd");
    }
    CHECK(d.ok());
    CHECK_FALSE(d.is_full());
    CHECK(d.all().size() == 1001);
    CHECK(d.render(d.all().back()) == "1001:1: warning: more than 1000 warnings: this one and all "
                                      "after it are not shown [too-many]\n");
    for (std::uint32_t i = 0; i < 2000; ++i) {
        CHECK(d.is_full() == (i > 1000));
        d.structural_error("e", {0, i + 1, 2}, "wrong");
    }
    d.sort();
    CHECK(d.errors() == 1001);
    CHECK(d.all().size() == 2002);
    CHECK(d.all().back() == Diagnostic{Diagnostic::Severity::error,
                                       false,
                                       "too-many",
                                       {0, 1001, 2},
                                       "more than 1000 errors: this one and all after it are not "
                                       "shown"});
}

TEST_CASE("diagnostics: the line of a place is found among many") {
    std::string text;
    for (int i = 1; i <= 300; ++i) {
        text += "line " + std::to_string(i) + "\n";
    }
    for (std::uint32_t i = 1; i <= 300; ++i) {
        CHECK(rendered(text, i, 6) == "f.xml:" + std::to_string(i) +
                                          ":6: error: what is wrong [some-id]\nline " +
                                          std::to_string(i) + "\n     ^\n");
    }
    CHECK(rendered(text, 999, 1) == "f.xml:999:1: error: what is wrong [some-id]\n");
}

TEST_CASE("diagnostics: structural errors are those that a schema finds as well") {
    Diagnostics d;
    d.error("e", {}, "only the compiler sees this");
    CHECK_FALSE(d.structural());
    d.structural_error("s", {}, "a schema sees this");
    CHECK(d.structural());
    CHECK(d.errors() == 2);
}

TEST_CASE("diagnostics: sort orders by place, keeps equal places in order and drops repetitions") {
    Diagnostics d;
    d.error("c", {1, 1, 1}, "other file");
    d.error("b", {0, 2, 5}, "second");
    d.error("a", {0, 2, 5}, "third");
    d.error("b", {0, 2, 5}, "second");
    d.warning("b", {0, 2, 5}, "second");
    d.error("d", {0, 1, 9}, "first");
    d.sort();
    std::string ids;
    for (const Diagnostic& x : d.all()) {
        ids += x.id;
    }
    CHECK(ids == "dbabc");
    CHECK(d.errors() == 4);
}

TEST_CASE("diagnostics: closest finds typing errors and only them") {
    const std::vector<std::string_view> names = {
        "Sequence", "Selector", "Fallback", "Repeat", "RetryUntilSuccessful", "If"};
    CHECK(closest("Sequnce", names) == "Sequence");
    CHECK(closest("Sequenec", names) == "Sequence");
    CHECK(closest("sequence", names) == "Sequence");
    CHECK(closest("FallBack", names) == "Fallback");
    CHECK(closest("RetryUntilSuccesful", names) == "RetryUntilSuccessful");
    CHECK(closest("Sequence", names) == "Sequence");
    CHECK(closest("MoveForward", names) == "");
    CHECK(closest("", names) == "");
    CHECK(closest("Of", names) == "");
    CHECK(closest("if", names) == "If");
    CHECK(closest(std::string(100000, 'x'), {std::string_view("x")}) == "");
}

TEST_CASE("diagnostics: a change of case counts half, so that it wins") {
    CHECK(closest("state", {"stats", "State"}) == "State");
    CHECK(closest("state", {"stata", "stats"}) == "stata");
}

TEST_CASE("diagnostics: suggestion is a clause to append, or nothing") {
    CHECK(suggestion("Sequnce", {"Sequence"}) == "; did you mean \"Sequence\"?");
    CHECK(suggestion("Xyz", {"Sequence"}) == "");
}
