// Parsing and writing of trees in one line.
// SPDX-License-Identifier: MIT
#include "support/tree_table.h"

#include "support/loading.h"
#include "support/script_leaves.h"

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
        out.coded = take('#');
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_])) != 0) {
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
            const std::string numbers(text_.substr(at_, text_.find(']', at_) - at_));
            out.number = std::stoi(numbers);
            const std::size_t colon = numbers.find(':');
            if (colon != std::string::npos) { out.second = std::stoi(numbers.substr(colon + 1)); }
            at_ += numbers.size() + 1;
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

/// The ports of a node that has numbers.
std::string ports(const TreeSpec& tree) {
    const std::string number = std::to_string(tree.number);
    const auto port = [](std::string_view name, std::string_view value) {
        return ' ' + std::string(name) + "=\"" + std::string(value) + '"';
    };
    const std::string& node = tree.node;
    if (node == "Repeat") { return port("num_cycles", number); }
    if (node == "RetryUntilSuccessful") { return port("num_attempts", number); }
    if (node == "Parallel") {
        return port("success_count", number) + port("failure_count", std::to_string(tree.second));
    }
    if (node == "ParallelAll") { return port("max_failures", number); }
    if (node == "Delay") { return port("delay_msec", number + "000"); }
    if (node == "Timeout") { return port("msec", number + "000"); }
    if (node == "RunOnce") { return port("then_skip", tree.number == 0 ? "true" : "false"); }
    if (node == "TryCatch") { return port("catch_on_halt", tree.number == 0 ? "false" : "true"); }
    if (node == "Precondition") {
        return port("if", "_x.bumper") + port("else", name_of(static_cast<Status>(tree.number)));
    }
    if (node == "SkipUnlessUpdated" || node == "WaitValueUpdate") { return port("entry", "{x}"); }
    if (node == "Script") { return port("code", "x := 1"); }
    std::string out;
    if (node == "LoopInt") {
        for (int i = 1; i <= tree.number; ++i) {
            out += (i == 1 ? "" : ";") + std::to_string(i);
        }
        return port("queue", out);
    }
    if (node.starts_with("Switch")) {
        out = port("variable", number);
        for (char i = '1'; i <= node.back(); ++i) {
            out += port(std::string("case_") + i, std::string(1, i));
        }
    }
    return out;
}

void append_xml(const TreeSpec& tree, std::size_t& leaves, std::string& out) {
    out += '<' + std::string(tree.coded ? "Coded" : "") + tree.node;
    if (tree.coded) {
        out += " id=\"" + std::to_string(leaves++) + "\" script=\"" +
               std::to_string(code_of(tree.script)) + '"';
    } else if (!tree.script.empty()) {
        out += " id=\"" + leaf_id(leaves++) + "\" script=\"" + tree.script + '"';
    }
    out += ports(tree);
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
    out += "</" + std::string(tree.coded ? "Coded" : "") + tree.node + '>';
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
    if (tree.coded) { out += '#'; }
    if (!tree.script.empty()) { return out + tree.script; }
    out += tree.node;
    const std::string second = tree.second != 0 ? ':' + std::to_string(tree.second) : "";
    if (tree.number != 0 || tree.second != 0) {
        out += '[' + std::to_string(tree.number) + second + ']';
    }
    const char* between = "(";
    for (const TreeSpec& child : tree.children) {
        out += between + notation(child);
        between = ", ";
    }
    return tree.children.empty() ? out : out + ')';
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
