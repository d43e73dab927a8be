// Sweep files: what they give, and exactly what is said about those that are wrong.
// SPDX-License-Identifier: MIT
#include "runner/sweep/spec.h"

#include <doctest/doctest.h>

#include <string>

namespace trellis {
namespace {

/// Findings as "line:column: id: message" lines.
std::string findings(const std::string& text) {
    Diagnostics diagnostics;
    const std::uint32_t file = diagnostics.add_file("s.json", text);
    const bool read = read_sweep(text, file, diagnostics).has_value();
    CHECK(read == diagnostics.ok());
    diagnostics.sort();
    std::string lines;
    for (const Diagnostic& d : diagnostics.all())
        lines += std::to_string(d.where.line) + ':' + std::to_string(d.where.column) + ": " + d.id +
                 ": " + d.message + '\n';
    return lines;
}

/// A sweep of one behaviour, with `more` members.
std::string sweep(const std::string& more) {
    return R"({"behaviours": [{"name": "a", "file": "a.xml"}], "times": [60])" + more + "}";
}

TEST_CASE("sweep file: every member is read") {
    const std::string text = R"({"$schema": "x", "doc": "y", "name": "n",
        "behaviours": [
            {"name": "a", "file": "a.xml", "tree": "T", "set": {"x": 1.50, "y": "b", "z": true}},
            {"file": "b.scxml"}],
        "worlds": ["lab", "w.json"],
        "parameters": [{"name": "p", "values": [1, "c", false]},
                       {"name": "q", "values": [2], "of": ["b.scxml"]}],
        "seeds": {"first": 5, "count": 7},
        "times": [600, 60, 600], "marks": [30.5], "cell": 0.1, "dt": 0.02})";
    Diagnostics diagnostics;
    const std::optional<SweepSpec> spec =
        read_sweep(text, diagnostics.add_file("s", text), diagnostics);
    CHECK(diagnostics.render() == "");
    REQUIRE(spec);
    CHECK(spec->name == "n");
    REQUIRE(spec->behaviours.size() == 2);
    const SpecBehaviour& a = spec->behaviours[0];
    CHECK(a.name == "a");
    CHECK(a.file.text == "a.xml");
    CHECK(a.tree == "T");
    REQUIRE(a.set.size() == 3);
    CHECK(a.set[0].name.text == "x");
    CHECK(a.set[0].value == "1.50");
    CHECK(a.set[1].value == "b");
    CHECK(a.set[2].value == "true");
    CHECK(spec->behaviours[1].name == "b.scxml");
    REQUIRE(spec->worlds.size() == 2);
    CHECK(spec->worlds[1].text == "w.json");
    REQUIRE(spec->parameters.size() == 2);
    CHECK(spec->parameters[0].values == std::vector<std::string>{"1", "c", "false"});
    CHECK(spec->parameters[0].is_of(a));
    CHECK_FALSE(spec->parameters[1].is_of(a));
    CHECK(spec->first_seed == 5);
    CHECK(spec->seeds == 7);
    CHECK(spec->times == std::vector{60.0, 600.0});
    CHECK(spec->marks == std::vector{30.5});
    CHECK(spec->cell == 0.1);
    CHECK(spec->dt == 0.02);
}

TEST_CASE("sweep file: what is not given") {
    Diagnostics diagnostics;
    const std::string text = sweep("");
    const std::optional<SweepSpec> spec =
        read_sweep(text, diagnostics.add_file("s", text), diagnostics);
    REQUIRE(spec);
    CHECK(spec->worlds.size() == 1);
    CHECK(spec->worlds[0].text == "lab");
    CHECK(spec->seeds == 1);
    CHECK(spec->cell == default_cell);
    CHECK(spec->dt == lab_dt);
}

TEST_CASE("sweep file: names, types and numbers") {
    CHECK(findings("[]") == "1:1: json-type: the file must be an object, found an array\n");
    CHECK(findings("{}") == "1:1: json-member: a sweep needs \"behaviours\"\n"
                            "1:1: json-member: a sweep needs \"times\"\n");
    CHECK(findings(R"({"behaviours": [], "times": []})") ==
          "1:16: bad-value: \"behaviours\" must not be empty\n"
          "1:29: bad-value: \"times\" must not be empty\n");
    CHECK(findings(R"({"behaviours": [{"name": "a"}], "times": ["1", 0]})") ==
          "1:17: json-member: a behaviour needs \"file\"\n"
          "1:44: json-type: each value of \"times\" must be a number, found text\n"
          "1:48: bad-value: each value of \"times\" must be above 0, up to 1000000, found 0\n");
    CHECK(findings(sweep(R"(, "world": ["lab"])")) ==
          "1:66: json-member: a sweep has no member \"world\"; did you mean \"worlds\"?\n");
    CHECK(findings(sweep(R"(, "seeds": {"count": 1.5})")) ==
          "1:84: bad-value: \"count\" must be a whole number, found 1.5\n");
    CHECK(findings(sweep(R"(, "cell": 0.001)")) ==
          "1:73: bad-value: \"cell\" must be from 0.005 to 1, found 0.001\n");
    CHECK(findings(sweep(R"(, "parameters": [{"name": "p", "values": [null]}])")) ==
          "1:105: json-type: each value of \"values\" must be a number, text, true or false, found "
          "null\n");
    CHECK(findings(R"({"behaviours": [{"file": "a", "set": {"x": [1]}}], "times": [1]})") ==
          "1:44: json-type: \"x\" must be a number, text, true or false, found an array\n");
}

TEST_CASE("sweep file: names that do not tell runs apart") {
    CHECK(findings(R"({"behaviours": [{"file": "a"}, {"file": "a"}], "times": [1]})") ==
          "1:32: sweep-name: there is another behaviour \"a\"; give one of them another "
          "\"name\"\n");
    CHECK(findings(sweep(R"(, "parameters": [{"name": "p", "values": [1], "of": ["A"]}])")) ==
          "1:117: sweep-name: there is no behaviour \"A\"\n");
    CHECK(findings(sweep(R"(, "parameters": [{"name": "p", "values": [1]},
{"name": "p", "values": [2]}])")) ==
          "2:11: sweep-name: the variable \"p\" of \"a\" gets values from two places\n");
}

TEST_CASE("sweep file: more runs than anyone can wait for") {
    CHECK(findings(sweep(R"(, "seeds": {"count": 1000000}, "worlds": ["lab"],
"parameters": [{"name": "p", "values": [1,2,3,4,5,6,7,8,9,10,11]},
{"name": "q", "values": [1,2,3,4,5,6,7,8,9,10]}])")) ==
          "1:1: sweep-size: a sweep has at most 100000000 runs, these are 110000000\n");
}

}  // namespace
}  // namespace trellis
