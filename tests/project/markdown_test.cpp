// Finding code blocks in a page (tests/project/markdown.h): a convention that is not recognised
// would be an example that nobody runs.
// SPDX-License-Identifier: MIT
#include "project/markdown.h"

#include <doctest/doctest.h>

using trellis::test::Page;
using trellis::test::read_page;

TEST_CASE("markdown: a block has its language, its text and its line") {
    const Page page =
        read_page("# Title\n\n```sh extra words\ntrellis run a.xml\n\nls\n```\nend\n");
    REQUIRE(page.blocks.size() == 1);
    CHECK(page.blocks[0].line == 3);
    CHECK(page.blocks[0].language == "sh");
    CHECK(page.blocks[0].text == "trellis run a.xml\n\nls\n");
    CHECK(page.faults.empty());
}

TEST_CASE("markdown: the fence's indentation is not part of the text") {
    const Page page = read_page("1. do\n   ```xml\n   <a>\n     <b/>\n   </a>\n   ```\n");
    REQUIRE(page.blocks.size() == 1);
    CHECK(page.blocks[0].text == "<a>\n  <b/>\n</a>\n");
}

TEST_CASE("markdown: a longer fence holds a shorter one") {
    const Page page = read_page("````text\n```sh\nls\n```\n````\n~~~json\n{}\n~~~\n");
    REQUIRE(page.blocks.size() == 2);
    CHECK(page.blocks[0].text == "```sh\nls\n```\n");
    CHECK(page.blocks[1].text == "{}\n");
}

TEST_CASE("markdown: comments directly above a block say how it is treated") {
    const Page page = read_page("<!-- file: a.xml -->\n\n```xml\n<a/>\n```\n"
                                "<!-- exit: 2 -->\n<!-- fragment -->\n```json\n{}\n```\n"
                                "<!-- not run: installs packages -->\n```sh\nx\n```\n"
                                "<!-- exit: 1 -->\nother text\n```sh\ny\n```\n");
    REQUIRE(page.blocks.size() == 4);
    CHECK(page.blocks[0].file == "a.xml");
    CHECK(page.blocks[1].exit == 2);
    CHECK(page.blocks[1].fragment);
    CHECK(page.blocks[2].not_run);
    CHECK(page.blocks[3].exit == 0);
    CHECK(page.faults.empty());
}

TEST_CASE("markdown: what would be passed over in silence is a fault") {
    CHECK(read_page("<!-- fiel: a.xml -->\n```xml\n<a/>\n```\n").faults ==
          std::vector<std::string>{"2: unknown comment above a block: <!-- fiel: a.xml -->"});
    CHECK(read_page("```\nls\n```\n").faults ==
          std::vector<std::string>{"1: a block without a language: say text if it is none"});
    CHECK(read_page("\n```sh\nls\n").faults ==
          std::vector<std::string>{"2: the block is not closed"});
}
