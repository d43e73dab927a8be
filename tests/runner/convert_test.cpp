// trellis convert: both ways, in place, and what it refuses.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

using namespace trellis;
using namespace trellis::test;

TEST_CASE("convert: to JSON and back is the same file") {
    MemoryFiles files;
    files.content["a.xml"] =
        run_on_disk({"convert", from_root("trees/roomba.xml"), "-", "--to", "xml"}).out;
    CHECK(run_words(files, {"convert", "a.xml", "a.json"}).exit == Exit::yes);
    CHECK(run_words(files, {"convert", "a.json", "b.xml"}).exit == Exit::yes);
    CHECK(files.content["b.xml"] == files.content["a.xml"]);
    CHECK(files.content["a.json"].find("\"doc\": ") != std::string::npos);
}

TEST_CASE("convert: a file onto itself, laid out evenly") {
    MemoryFiles files;
    files.content["a.xml"] = "<root BTCPP_format='4'><!-- why --><BehaviorTree ID='A'>"
                             "<GoBack  speed='1'/></BehaviorTree></root>";
    const Ran ran = run_words(files, {"convert", "a.xml", "a.xml"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out + ran.err == "");
    CHECK(files.content["a.xml"] == "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                    "<root BTCPP_format=\"4\">\n"
                                    "  <!-- why -->\n"
                                    "  <BehaviorTree ID=\"A\">\n"
                                    "    <GoBack speed=\"1\"/>\n"
                                    "  </BehaviorTree>\n"
                                    "</root>\n");
}

TEST_CASE("convert: from a pipe to a pipe") {
    MemoryFiles files;
    const Ran ran = run_words(files, {"convert", "-", "-", "--to", "json"}, two_states);
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out.starts_with("{\n"));
    CHECK(run_words(files, {"convert", "-", "-", "--to", "xml"}, ran.out)
              .out.find("<final id=\"done\"/>") != std::string::npos);
}

TEST_CASE("convert: what cannot be converted leaves the output as it was") {
    MemoryFiles files;
    files.content = {{"a.xml", "<root>"}, {"b.xml", "<other/>"}, {"out.json", "old"}};
    Ran ran = run_words(files, {"convert", "a.xml", "out.json"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.starts_with("a.xml:1:"));
    ran = run_words(files, {"convert", "b.xml", "out.json"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err == "trellis: b.xml is neither a tree file, with the root element <root>, nor a "
                     "machine, with the root element <scxml>\n");
    ran = run_words(files, {"convert", "c.xml", "out.json"});
    CHECK(ran.exit == Exit::file);
    ran = run_words(files, {"convert", "a.xml", "out.txt"});
    CHECK(ran.exit == Exit::usage);
    CHECK(ran.err == "trellis: the name \"out.txt\" does not say what to write: give --to xml or "
                     "--to json\n");
    CHECK(files.content["out.json"] == "old");
}
