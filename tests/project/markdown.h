// The fenced code blocks of a Markdown page, with the comments that say how a test treats them. Not
// a Markdown parser. Covered by markdown_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

/// One fenced block. The members after `text` come from the HTML comments directly above the fence:
/// `<!-- file: NAME -->`, `<!-- exit: N -->`, `<!-- fragment -->`, `<!-- not run: REASON -->`.
struct Block {
    int line = 0;          ///< of the opening fence, from 1
    std::string language;  ///< first word after the fence; may be empty
    std::string text;      ///< without the fences and their indentation; ends with a newline
    std::string file;      ///< name to write it to; empty if none was given
    int exit = 0;          ///< exit status that is expected
    bool fragment = false;
    bool not_run = false;
};

struct Page {
    std::vector<Block> blocks;
    std::vector<std::string> faults;  ///< "12: unknown comment above a block: …", in page order
};

/// The blocks of a page in order. An unclosed fence, a block without a language and a comment above
/// a block that says none of the four things are faults.
Page read_page(std::string_view markdown);

}  // namespace trellis::test
