// The page of a sweep: what it holds, and that its commands give the runs it shows.
// SPDX-License-Identifier: MIT
#include "runner/command.h"

#include <doctest/doctest.h>

#include <string>

using namespace trellis;
using namespace trellis::test;

namespace {

const char* const sweep_file = R"json({"name": "a <sweep>",
"behaviours": [{"name": "one", "file": "a.scxml", "set": {"turn": 0.5}}, {"file": "a.scxml"}],
"parameters": [{"name": "speed", "values": [0.2, 0.5]}, {"name": "time", "values": [1, 2]}],
"seeds": {"count": 2}, "times": [5, 10]})json";

const char* const machine =
    R"xml(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" datamodel="script">
  <datamodel>
    <data id="speed" expr="0.1"/><data id="time" expr="1"/><data id="turn" expr="1"/>
  </datamodel>
  <state id="go">
    <invoke type="leaf" src="SetVelocity"><param name="linear" expr="speed"/></invoke>
    <transition event="tick" cond="elapsed() &gt; time" target="turning"/>
  </state>
  <state id="turning">
    <invoke type="leaf" src="SetVelocity"><param name="angular" expr="turn"/></invoke>
    <transition event="tick" cond="elapsed() &gt; 0.5" target="go"/>
  </state>
</scxml>
)xml";

/// The page, and the files it came from.
std::string page(MemoryFiles& files) {
    files.content["s.json"] = sweep_file;
    files.content["a.scxml"] = machine;
    const Ran ran = run_words(files, {"sweep", "s.json", "--report", "out.html"});
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.err == "");
    return files.content["out.html"];
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

}  // namespace

TEST_CASE("sweep report: curves, maps, runs and numbers, in one page of its own") {
    MemoryFiles files;
    const std::string html = page(files);
    CHECK(html.starts_with("<!doctype html>\n"));
    CHECK(html.find("<h1>a &lt;sweep&gt;</h1>") != std::string::npos);
    CHECK(count(html, "class=\"line c") == 8);
    CHECK(count(html, "class=\"band c") == 8);
    CHECK(count(html, "<table class=\"map\">") == 2);
    CHECK(count(html, "<h3>Best: ") == 1);
    CHECK(count(html, "<h3>Worst: ") == 1);
    CHECK(html.find("covered, %") != std::string::npos);
    // nothing is fetched from anywhere
    CHECK(html.find("src=") == std::string::npos);
    CHECK(html.find("href=\"http") == std::string::npos);
    CHECK(page(files) == html);
}

TEST_CASE("sweep report: the command repeats the run") {
    MemoryFiles files;
    const std::string html = page(files);
    const std::size_t best = html.find("<h3>Best: ") + 10;
    const std::string covered = html.substr(best, html.find(" %", best) - best);
    const std::size_t begin = html.find("<pre>trellis run ", best) + 13;
    std::string command = html.substr(begin, html.find("</pre>", begin) - begin);
    std::vector<std::string> words;
    for (std::size_t at = 0; at < command.size();) {
        const std::size_t end = std::min(command.find(' ', at), command.size());
        words.push_back(command.substr(at, end - at));
        at = end + 1;
    }
    const Ran ran = run_words(files, words);
    CHECK(ran.exit == Exit::yes);
    CHECK(ran.out.find("covered   " + covered + " % of ") != std::string::npos);
}

TEST_CASE("sweep report: a page that cannot be written") {
    MemoryFiles files;
    files.refused = {"out.html"};
    files.content["s.json"] = R"({"behaviours": [{"file": "a.scxml"}], "times": [1]})";
    files.content["a.scxml"] = two_states;
    const Ran ran = run_words(files, {"sweep", "s.json", "--report", "out.html"});
    CHECK(ran.exit == Exit::file);
    CHECK(ran.err == "trellis: cannot write \"out.html\": Permission denied\n");
}
