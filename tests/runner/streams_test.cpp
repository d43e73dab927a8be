// Reading and writing under a name or "-", and coloured messages.
// SPDX-License-Identifier: MIT
#include "runner/streams.h"

#include "load/diagnostics.h"
#include "runner/command.h"

#include <doctest/doctest.h>

#include <sstream>

using namespace trellis;
using namespace trellis::test;

namespace {

struct Box {
    MemoryFiles files;
    std::istringstream in{"from the pipe"};
    std::ostringstream out, err;
    Streams streams{in, out, err, files};
};

}  // namespace

TEST_CASE("streams: - is standard input and standard output") {
    Box box;
    CHECK(read_text("-", box.streams) == "from the pipe");
    CHECK(write_text("-", "to the pipe", box.streams));
    CHECK(box.out.str() == "to the pipe");
    CHECK(box.files.content.empty());
    CHECK(box.err.str() == "");
}

TEST_CASE("streams: what cannot be read or written is said with its reason") {
    Box box;
    box.files.refused = {"locked"};
    box.files.full = {"disk"};
    CHECK_FALSE(read_text("nothing", box.streams));
    CHECK_FALSE(write_text("locked", "x", box.streams));
    CHECK_FALSE(write_text("disk", "x", box.streams));
    CHECK(box.err.str() == "trellis: cannot read \"nothing\": No such file or directory\n"
                           "trellis: cannot write \"locked\": Permission denied\n"
                           "trellis: cannot write \"disk\": No space left on device\n");
    CHECK(box.files.content.empty());
}

TEST_CASE("streams: findings are the same text with and without colour") {
    Box box;
    Diagnostics diagnostics;
    diagnostics.add_file("a.xml", "<root>\n");
    diagnostics.error("some-id", {0, 1, 2}, "this is wrong");
    diagnostics.warning("other-id", {}, "this is odd");
    show(diagnostics, box.streams);
    CHECK(box.err.str() == "a.xml:1:2: error: this is wrong [some-id]\n"
                           "<root>\n"
                           " ^\n"
                           "a.xml: warning: this is odd [other-id]\n"
                           "1 error, 1 warning\n");
    box.err.str("");
    box.streams.colour = true;
    show(diagnostics, box.streams);
    CHECK(box.err.str() ==
          "\x1b[1ma.xml:1:2: \x1b[0m\x1b[1;31merror: \x1b[0mthis is wrong [some-id]\n"
          "<root>\n"
          "\x1b[1;32m ^\x1b[0m\n"
          "\x1b[1ma.xml: \x1b[0m\x1b[1;35mwarning: \x1b[0mthis is odd [other-id]\n"
          "1 error, 1 warning\n");
}
