// trellis run --world: worlds from files, and what is said of those that are none.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

namespace {

MemoryFiles files() {
    MemoryFiles files;
    files.content["a.xml"] = forward_tree;
    files.content["room.json"] =
        R"({"starts": [{"x": 1, "y": 1}], "rooms": [{"corners": [[0, 0], [1.2, 0], [1.2, 2], [0, 2]]}]})";
    return files;
}

}  // namespace

TEST_CASE("world: a run in a world from a file stops at its walls") {
    MemoryFiles given = files();
    const Ran ran = run_words(given, {"run", "a.xml", "--world", "room.json", "--time", "1"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.err == "");
    CHECK(ran.out.find("start     x 1.000 m, y 1.000 m, rotation 0.000 rad\n") !=
          std::string::npos);
    CHECK(ran.out.find("end       x 1.030 m, y 1.000 m, rotation 0.000 rad\n") !=
          std::string::npos);
}

TEST_CASE("world: a place where the robot does not fit is refused") {
    MemoryFiles given = files();
    const Ran ran =
        run_words(given, {"run", "a.xml", "--world", "room.json", "--pose", "1.19,1,0"});
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: --pose: the robot does not fit there\n");
}

TEST_CASE("world: files that are no worlds, and names that are none") {
    MemoryFiles given = files();
    given.content["bad.json"] = R"({"starts": [], "rooms": []})";
    const Ran bad = run_words(given, {"run", "a.xml", "--world", "bad.json"});
    CHECK(bad.exit == Exit::no);
    CHECK(bad.err.starts_with("bad.json:1:12: error: \"starts\" must not be empty [bad-value]\n"));
    CHECK(run_words(given, {"run", "a.xml", "--world", "none.json"}).exit == Exit::file);
    const Ran name = run_words(given, {"run", "a.xml", "--world", "lob"});
    CHECK(name.exit == Exit::usage);
    CHECK(name.err ==
          "trellis: --world: expected lab, none or FILE.json, found \"lob\"; did you mean "
          "\"lab\"?\ntry: trellis run --help\n");
}
