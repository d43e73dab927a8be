// Parsing and writing of trees in one line.
// SPDX-License-Identifier: MIT
#include "support/tree_table.h"

#include "support/loading.h"

#include <algorithm>
#include <cctype>

namespace trellis::test {

namespace {

bool is_script(std::string_view word) {
    return !word.empty() && word.find_first_not_of("SFRK") == std::string_view::npos;
}

class Parser {
public:
    explicit Parser(std::string_view text) : text_(text) {}

    TreeSpec tree() {
        TreeSpec out;
        skip_blanks();
        while (at_ + 1 < text_.size() && text_[at_ + 1] == '?') {
            out.before += text_[at_];
            at_ += 2;
        }
        const bool synchronous = take('=');
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
        const std::string_view word = text_.substr(begin, at_ - begin);
        if (is_script(word)) {
            out.node = synchronous ? "SyncLeaf" : "Leaf";
            out.script = word;
            return out;
        }
        out.node = word;
        if (take('[')) {
            out.number = std::stoi(std::string(text_.substr(at_)));
            at_ = text_.find(']', at_) + 1;
        }
        if (take('(')) {
            do {
                out.children.push_back(tree());
            } while (take(','));
            take(')');
        }
        return out;
    }

private:
    void skip_blanks() {
        while (at_ < text_.size() && text_[at_] == ' ') {
            ++at_;
        }
    }
    bool take(char c) {
        skip_blanks();
        if (at_ == text_.size() || text_[at_] != c) { return false; }
        ++at_;
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

void append_xml(const TreeSpec& tree, std::size_t& leaves, std::string& out) {
    out += '<' + tree.node;
    if (!tree.script.empty()) {
        out += " id=\"" + leaf_id(leaves++) + "\" script=\"" + tree.script + '"';
    }
    const std::string number = '"' + std::to_string(tree.number) + '"';
    if (tree.node == "Repeat") { out += " num_cycles=" + number; }
    if (tree.node == "RetryUntilSuccessful") { out += " num_attempts=" + number; }
    for (const char letter : tree.before) {
        const std::string_view name = letter == 'f'   ? "_failureIf"
                                      : letter == 's' ? "_successIf"
                                      : letter == 'k' ? "_skipIf"
                                                      : "_while";
        out += ' ' + std::string(name) + "=\"_x.bumper\"";
    }
    out += '>';
    for (const TreeSpec& child : tree.children) {
        append_xml(child, leaves, out);
    }
    out += "</" + tree.node + '>';
}

}  // namespace

TreeSpec parse_tree(std::string_view text) {
    return Parser(text).tree();
}

std::string notation(const TreeSpec& tree) {
    std::string out;
    for (const char letter : tree.before) {
        out += letter;
        out += '?';
    }
    if (tree.node == "SyncLeaf") { out += '='; }
    if (!tree.script.empty()) { return out + tree.script; }
    out += tree.node;
    if (tree.number != 0) { out += '[' + std::to_string(tree.number) + ']'; }
    const char* between = "(";
    for (const TreeSpec& child : tree.children) {
        out += between + notation(child);
        between = ", ";
    }
    return tree.children.empty() ? out : out + ')';
}

std::string leaf_id(std::size_t n) {
    std::string id(1, static_cast<char>('a' + n % 26));
    return n < 26 ? id : leaf_id(n / 26 - 1) + id;
}

std::string xml_of(const TreeSpec& tree) {
    std::string out = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">";
    std::size_t leaves = 0;
    append_xml(tree, leaves, out);
    return out + "</BehaviorTree></root>";
}

std::string table(std::string_view text, std::size_t ticks, std::string_view bumper) {
    const Program program = loaded(xml_of(parse_tree(text)));
    ScriptRun run(program);
    std::string out;
    std::vector<std::string> rows(program.rows.size());
    for (std::size_t i = 0; i < ticks; ++i) {
        run.host.bumper = bumper[i % bumper.size()] == '1';
        out += "-RSFK"[static_cast<std::size_t>(run.step())];
        const std::string stored = run.statuses();
        for (std::size_t n = 0; n < rows.size(); ++n) {
            rows[n] += stored[n];
        }
    }
    out += " |";
    for (std::size_t n = 1; n < rows.size(); ++n) {
        out += ' ' + rows[n];
    }
    return out;
}

std::string events(std::string_view text, std::size_t ticks, std::string_view bumper) {
    const Program program = loaded(xml_of(parse_tree(text)));
    ScriptRun run(program);
    std::string out;
    for (std::size_t i = 0; i < ticks; ++i) {
        run.host.bumper = bumper[i % bumper.size()] == '1';
        run.step();
        if (i > 0) { out += " / "; }
        out += run.take_events();
    }
    return out;
}

}  // namespace trellis::test
