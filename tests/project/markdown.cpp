// The fenced code blocks of a Markdown page: see markdown.h.
// SPDX-License-Identifier: MIT
#include "project/markdown.h"

#include "support/files.h"

#include <algorithm>
#include <cstdlib>

namespace trellis::test {
namespace {

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

/// The backticks or tildes (three or more) that `line`, without indentation, opens with; else
/// empty.
std::string_view fence_of(std::string_view line) {
    if (!line.starts_with("```") && !line.starts_with("~~~")) return {};
    return line.substr(0, std::min(line.find_first_not_of(line.front()), line.size()));
}

/// Puts what the comment says into `block`; false if it says nothing known.
bool apply(std::string_view comment, Block& block) {
    comment.remove_prefix(std::string_view("<!--").size());
    comment = trimmed(comment.substr(0, comment.find("-->")));
    const std::string_view key = comment.substr(0, comment.find(':'));
    const std::string value(trimmed(comment.substr(std::min(key.size() + 1, comment.size()))));
    if (key == "file" && !value.empty()) {
        block.file = value;
    } else if (key == "exit" && !value.empty()) {
        block.exit = std::atoi(value.c_str());
    } else if (key == "fragment" && value.empty()) {
        block.fragment = true;
    } else if (key == "not run" && !value.empty()) {
        block.not_run = true;
    } else {
        return false;
    }
    return true;
}

}  // namespace

Page read_page(std::string_view markdown) {
    Page page;
    std::vector<std::string_view> comments;  // since the last line of other text
    std::string_view fence;                  // of the open block; empty between blocks
    std::size_t indentation = 0;             // of the open block's fence
    int number = 0;
    const auto fault = [&](int line, std::string_view what, std::string_view detail) {
        page.faults.push_back(std::to_string(line) + ": " + std::string(what) +
                              std::string(detail));
    };
    for (const std::string_view line : lines_of(markdown)) {
        ++number;
        const std::string_view content = trimmed(line);
        if (!fence.empty()) {
            // a closing fence is at least as long as the opening one, and alone
            if (content.starts_with(fence) && fence_of(content) == content) {
                fence = {};
            } else {
                const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
                page.blocks.back().text += line.substr(std::min(blanks, indentation));
                page.blocks.back().text += '\n';
            }
        } else if (fence = fence_of(content); !fence.empty()) {
            indentation = line.find(fence);
            Block block;
            block.line = number;
            block.language = trimmed(content.substr(fence.size()));
            block.language.resize(std::min(block.language.find(' '), block.language.size()));
            if (block.language.empty())
                fault(number, "a block without a language: ", "say text if it is none");
            for (const std::string_view comment : comments)
                if (!apply(comment, block))
                    fault(number, "unknown comment above a block: ", comment);
            comments.clear();
            page.blocks.push_back(block);
        } else if (content.starts_with("<!--") && content.ends_with("-->")) {
            comments.push_back(content);
        } else if (!content.empty()) {
            comments.clear();
        }
    }
    if (!fence.empty()) fault(page.blocks.back().line, "the block is not closed", "");
    return page;
}

}  // namespace trellis::test
