// The real program: exit codes, pipes, the environment, and the lab's recorded runs byte for byte.
// SPDX-License-Identifier: MIT
#include "runner/command.h"
#include "runner/shell.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

using namespace trellis::test;

TEST_CASE("program: exit codes") {
    CHECK(shell("$trellis validate trees/roomba.xml").exit == 0);
    CHECK(shell("echo '<root/>' | $trellis validate - 2>&1").exit == 1);
    CHECK(shell("$trellis validat 2>&1").exit == 2);
    CHECK(shell("$trellis validate no-such-file 2>&1").exit == 3);
}

TEST_CASE("program: a reader that goes away ends it quietly") {
    // the exit code of the first command of the pipe, and its messages
    const Shell gone = shell("{ { $trellis run trees/roomba.xml --ticks 20000 --trace - 2>&1 >&3; "
                             "echo $? >&2; } 3>&1 >&2 | head -c 1 >/dev/null; } 2>&1");
    CHECK(gone.out.ends_with("3\n"));
    CHECK(gone.out.find("trellis:") == std::string::npos);
}

TEST_CASE("program: a full disk behind standard output") {
    const Shell full = shell("$trellis nodes 2>&1 >/dev/full");
    CHECK(full.exit == 3);
    CHECK(full.out == "trellis: cannot write standard output: No space left on device\n");
}

TEST_CASE("program: the environment decides on colour") {
    const std::string command = "$trellis validate tests/faults/tree_many_faults.xml 2>&1";
    CHECK(shell(command).out.find('\x1b') == std::string::npos);
    CHECK(shell("CLICOLOR_FORCE=1 " + command).out.find('\x1b') != std::string::npos);
    CHECK(shell("NO_COLOR=1 CLICOLOR_FORCE=1 " + command).out.find('\x1b') == std::string::npos);
}

TEST_CASE("program: the lab's recorded runs, byte for byte") {
    const std::filesystem::path lab = std::filesystem::path(TRELLIS_SHARED_DIR) / "lab";
    if (!std::filesystem::exists(lab) || shell("command -v xz >/dev/null").exit != 0) {
        MESSAGE("no recorded runs, or no xz: nothing compared");
        return;
    }
    for (const std::string file :
         {"fsm machines/roomba.scxml", "fsm machines/roomba.json", "bt trees/roomba.xml",
          "bt trees/roomba.json", "bt trees/roomba_primitives.xml"}) {
        INFO(file);
        const std::string kind = file.substr(0, file.find(' '));
        const std::string behaviour = file.substr(file.find(' ') + 1);
        const std::string recorded =
            "xz -dc '" + (lab / kind / "r00.csv.xz").string() + "' | cut -d, -f1-9 | cksum";
        const std::string ours = "$trellis run " + behaviour + " --draws '" +
                                 (lab / "angles/r00.txt").string() +
                                 "' --ticks 36000 --trace - 2>/dev/null | cksum";
        CHECK(shell(ours).out == shell(recorded).out);
    }
}
