// trellis compare: that it finds the first difference and says why, for the lab's behaviours and
// for small ones.
// SPDX-License-Identifier: MIT
#include "runner/command.h"
#include "support/files.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace trellis;
using namespace trellis::test;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
        text.replace(at, what.size(), by);
    }
    return text;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("compare: the lab's machine and tree part in tick 181, and why") {
    MemoryFiles files;
    for (const std::string file : {"machines/roomba.scxml", "trees/roomba.xml"}) {
        files.content[file] = read_file(from_root(file));
    }
    const Ran ran = run_words(files, {"compare", "machines/roomba.scxml", "trees/roomba.xml"});
    CHECK(ran.exit == Exit::no);
    const std::string& out = ran.out;
    const std::string first = out.substr(0, out.find("machines/roomba.scxml: "));
    CHECK(first == "seed 0: they differ first in tick 181 (3.017 s), in leaf, x, y, rotation, w\n"
                   "\n"
                   "           machines/roomba.scxml     trees/roomba.xml\n"
                   "leaf                 MoveForward         MoveInSpiral\n"
                   "its ticks                    181                    1\n"
                   "x              4.708333333333366    4.708331790209221\n"
                   "y                            2.4    2.400138876029283\n"
                   "rotation                     0.0  0.03333333333333333\n"
                   "v                            0.5                  0.5\n"
                   "w                            0.0                  2.0\n"
                   "bumper                         0                    0\n"
                   "\n");
    CHECK(contains(out, "machines/roomba.scxml: in tick 181, MoveForward went on, in its 181st "
                        "tick (3.0166666666666666 s).\n"));
    CHECK(contains(out, "None of them fired: MoveForward had run for 180 ticks (3.0 s)."));
    CHECK(contains(out, "  Next, in tick 182: the transition \"elapsed() > forward_time\" (line "));
    CHECK(contains(out, "trees/roomba.xml: in tick 181, MoveForward ended with SUCCESS in its "
                        "181st tick (3.0166666666666666 s), and MoveInSpiral began.\n"));
    CHECK(contains(out, "So the step to MoveInSpiral comes 1 tick later in machines/roomba.scxml, "
                        "and the robot has moved differently by then.\n"));
}

TEST_CASE("compare: a spelling and another of one behaviour do not differ") {
    const Ran ran = run_on_disk({"compare", from_root("trees/roomba.xml"),
                                 from_root("trees/roomba_primitives.json"), "--seeds", "3"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out.starts_with("seed 0, seed 1, seed 2: no difference in 3600 ticks\n"));
    CHECK(ran.out.ends_with("\nthe robots are never apart\n"));
}

TEST_CASE("compare: names alone are no difference") {
    MemoryFiles files;
    files.content["a.xml"] = forward_tree;
    files.content["b.xml"] = replaced(forward_tree, "<MoveForward", "<MoveForward name=\"ahead\"");
    const Ran ran = run_words(files, {"compare", "a.xml", "b.xml", "--ticks", "9"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out.starts_with("seed 0: no difference in 9 ticks\n"));
}

TEST_CASE("compare: equal leaves with other numbers, from the first tick on") {
    MemoryFiles files;
    files.content["a.xml"] = forward_tree;
    files.content["b.xml"] = replaced(forward_tree, "<MoveForward", "<MoveForward speed=\"0.25\"");
    const Ran ran = run_words(files, {"compare", "a.xml", "b.xml", "--ticks", "9"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out.starts_with("seed 0: they differ first in tick 1 (0.017 s), in x, v\n"));
    CHECK(contains(ran.out, "Both go on with what they do, but do not command the same velocity."));
    CHECK(contains(ran.out, "\nentered MoveForward         3        3\n"));
    CHECK(contains(ran.out, "\ndriven                0.075 m  0.037 m\n"));
}

TEST_CASE("compare: one run that ends before the other is a difference") {
    MemoryFiles files;
    files.content["a.scxml"] = two_states;
    files.content["b.scxml"] = replaced(two_states, "0.04", "0.05");
    const Ran ran = run_words(files, {"compare", "a.scxml", "b.scxml"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.out.starts_with("seed 0: they differ first in tick 4 (0.067 s), in leaf, ended\n"));
    CHECK(contains(ran.out, "a.scxml: in tick 4, the transition \"elapsed() > 0.04\" (line 5) of "
                            "go was taken, go was left after 3 ticks (0.05 s), and done began.\n"));
    CHECK(contains(ran.out, "So the step to done comes 1 tick later in b.scxml"));
}

TEST_CASE("compare: as JSON, one run for each seed") {
    MemoryFiles files;
    files.content = {{"a.scxml", two_states}, {"b.xml", forward_tree}};
    const Ran ran = run_words(
        files, {"compare", "a.scxml", "b.xml", "--seed", "3", "--seed", "5", "--format", "json"});
    CHECK(ran.exit == Exit::no);
    const auto report = nlohmann::json::parse(ran.out);
    CHECK(report["equal"] == false);
    CHECK(report["runs"].size() == 2);
    CHECK(report["runs"][1]["random"] == "seed 5");
    CHECK(report["runs"][1]["first"]["tick"] == 1);
    CHECK(report["runs"][1]["first"]["columns"] == nlohmann::json::parse(R"(["x", "v"])"));
    CHECK(report["runs"][1]["first"]["a"]["leaf"] == "go");
    CHECK(report["statistics"][0]["name"] == "share of go");
    CHECK(report["statistics"][0].contains("b") == false);
}

TEST_CASE("compare: a run that fails, and files that cannot be read") {
    MemoryFiles files;
    files.content = {{"a.xml", replaced(forward_tree, "MoveForward duration=\"0.05\"", "Rotate")},
                     {"none.txt", ""}};
    const Ran ran = run_words(files, {"compare", "a.xml", "a.xml", "--draws", "none.txt"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "a.xml:3:6: error: Rotate: there are no random numbers left (tick 1)\n");
    CHECK(run_words(files, {"compare", "a.xml", "b.xml"}).exit == Exit::file);
    CHECK(run_words(files, {"compare", "-", "-"}).exit == Exit::usage);
}
