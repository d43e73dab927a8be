// What a hostile file gets from the program: a diagnostic, soon, and no more memory than the limits
// of load/document.h and load/load.h allow. The sizes here are moderate; bench/README.md has the
// figures for the largest. The readers' own faults are in tests/load.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

using namespace trellis;
using namespace trellis::test;

namespace {

const std::string head = "<root BTCPP_format='4'><BehaviorTree ID='T'>";
const std::string tail = "</BehaviorTree></root>";

std::string repeated(std::string_view piece, std::size_t times) {
    std::string out;
    for (std::size_t i = 0; i < times; ++i) {
        out += piece;
    }
    return out;
}

/// The last finding about a file of that text, without its place and its excerpt.
std::string last_finding(const std::string& text) {
    MemoryFiles files;
    files.content["f"] = text;
    const Ran ran = run_words(files, {"validate", "f"});
    CHECK(ran.exit == Exit::no);
    const std::size_t begin = ran.err.rfind("error: ");
    return ran.err.substr(begin, ran.err.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("hostile files: a tree without end in depth is refused at the limit") {
    const std::string deep = "elements are nested more than 256 deep [too-large]";
    CHECK(last_finding(head + repeated("<Sequence>", 100'000)) == "error: " + deep);
    const std::string json = R"({"BTCPP_format":4,"trees":[{"ID":"T","root":)" +
                             repeated(R"({"type":"Sequence","children":[)", 300) +
                             repeated("]}", 300) + "}]}";
    CHECK(last_finding(json) == "error: " + deep);
    CHECK(last_finding(repeated("[", 100'000)) ==
          "error: values are nested more than 1028 deep [too-large]");
}

TEST_CASE("hostile files: elements and attributes are counted while they are read") {
    CHECK(last_finding(head + repeated("<a/>", 1'300'000)) ==
          "error: the file has more than 1100000 elements [too-large]");
    CHECK(last_finding("[" + repeated("0,", 3'100'000)) ==
          "error: the file has more than 2500000 values [too-large]");
    std::string wide = head + "<a";
    for (int i = 0; i < 2'600'000; ++i) {
        wide += " b=''";
    }
    CHECK(last_finding(wide) == "error: the file has more than 2000000 attributes [too-large]");
}

TEST_CASE("hostile files: a file of nothing but faults gets a thousand findings") {
    CHECK(last_finding(head + "<Sequence>" + repeated("<Sequenze/>", 100'000) + "</Sequence>" +
                       tail) ==
          "error: more than 1000 errors: this one and all after it are not shown [too-many]");
}

TEST_CASE("hostile files: a file above the limit of bytes is not read") {
    MemoryFiles files;
    files.content["f"] = head + "<AlwaysSuccess name='" + std::string(65 << 20, 'x') + "'/>" + tail;
    const Ran ran = run_words(files, {"validate", "f"});
    CHECK(ran.exit == Exit::file);
    CHECK(ran.err == "trellis: cannot read \"f\": File too large\n");
}

TEST_CASE("hostile files: includes end, even if each file includes two others without end") {
    /// Every path is a file that includes two more of the folder below.
    class Folders : public Files {
    public:
        std::optional<std::string> read(const std::string& path, std::size_t,
                                        std::string&) override {
            return "<root BTCPP_format='4'><include path='a/f'/><include path='b/f'/>" +
                   (path == "f" ? "<BehaviorTree ID='T'><AlwaysSuccess/></BehaviorTree>"
                                : std::string()) +
                   "</root>";
        }
        std::unique_ptr<OutputFile> create(const std::string&, std::string&) override {
            return nullptr;
        }
        std::unique_ptr<GrowingFile> grow(const std::string&, std::string&) override {
            return nullptr;
        }
        void remove(const std::string&) override {}
    };
    Folders files;
    const Ran ran = run_words(files, {"validate", "f"});
    CHECK(ran.exit == Exit::no);
    CHECK(ran.err.find("error: the included files are more than 1000 [too-large]") !=
          std::string::npos);
}

TEST_CASE("hostile files: NUL, bytes that are no UTF-8 and definitions of entities are named") {
    CHECK(last_finding(head + std::string(1, '\0') + tail) ==
          "error: the character U+0000 is not allowed in a file [character]");
    CHECK(last_finding(head + "\xC0\x80" + tail) ==
          "error: the file is not UTF-8: found the byte 0xC0 [encoding]");
    CHECK(last_finding("<!DOCTYPE r [<!ENTITY a \"&a;&a;\">]>" + head + "&a;" + tail) ==
          "error: document type definitions are not read: remove it [doctype]");
}
