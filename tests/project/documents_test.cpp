// Every code block of README.md and docs/ is run, compiled or validated, page by page, in a fresh
// folder with copies of trees/, machines/ and schemas/ and the built program in PATH:
//   sh            run; "$ " lines are commands, the lines below them their output ("…": anything)
//   xml, json     validated by `trellis validate`, or only parsed when marked as a fragment
//   cpp           with a file name: compiled; a .cpp with main becomes a program in the folder
// A comment above a block says more: .github/CONTRIBUTING.md lists them. Other languages are left
// alone. The rules of reading a page are tested in markdown_test.cpp and transcript_test.cpp.
// SPDX-License-Identifier: MIT
#include "project/markdown.h"
#include "project/transcript.h"
#include "support/files.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace trellis::test;
namespace fs = std::filesystem;

/// A new empty folder outside the repository, removed with everything in it at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "trellis-page-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~TemporaryFolder() { fs::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// The text as one word of a shell command.
std::string shell_word(std::string_view text) {
    std::string quote = "'";
    for (const char c : text)
        quote += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quote + "'";
}

struct Result {
    int exit = 0;
    std::string output;  ///< standard output and error, as a terminal shows them
};

/// One page's folder and what happens in it; each fault is reported with the page and the line.
class PageRun {
public:
    explicit PageRun(std::string page) : page_(std::move(page)), folder_(base_.path() / "page") {
        fs::create_directory(folder_);
        for (const std::string_view data : {"trees", "machines", "schemas"}) {
            const fs::path from = fs::path(TRELLIS_SOURCE_DIR) / data;
            if (fs::exists(from)) fs::copy(from, folder_ / data, fs::copy_options::recursive);
        }
    }

    void run(const Block& block) {
        if (block.not_run) return;
        if (!block.file.empty()) write(folder_ / block.file, block.text);
        if (block.language == "sh") {
            run_shell(block);
        } else if (block.language == "cpp") {
            compile(block);
        } else if (block.file.empty() && (block.language == "xml" || block.language == "json")) {
            block.fragment ? parse(block) : validate(block);
        }
    }

private:
    void fault(const Block& block, std::string_view what, std::string_view detail) const {
        FAIL_CHECK(page_, ":", block.line, ": ", what, "\n", detail);
    }

    static void write(const fs::path& path, std::string_view text) {
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
    }

    /// Runs a script with sh in the page's folder; without standard input.
    Result shell(std::string_view script) const {
        const fs::path file = base_.path() / "script.sh";
        write(file, script);
        const std::string bin = fs::path(TRELLIS_PROGRAM).parent_path().string();
        const std::string command =
            "cd " + shell_word(folder_.string()) + " && PATH=" + shell_word(bin) +
            ":\"$PATH\" LC_ALL=C.UTF-8 CMAKE_PREFIX_PATH=" + shell_word(TRELLIS_INSTALLED) +
            " CXX=" + shell_word(TRELLIS_CXX) + " CXXFLAGS=" + shell_word(TRELLIS_CXX_FLAGS) +
            " sh " + shell_word(file.string()) + " </dev/null 2>&1";
        Result result;
        FILE* pipe = popen(command.c_str(), "r");
        REQUIRE(pipe != nullptr);
        char buffer[4096];
        while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe))
            result.output.append(buffer, n);
        const int status = pclose(pipe);
        result.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return result;
    }

    void expect_exit(const Block& block, std::string_view what, int expected,
                     const Result& result) const {
        if (result.exit != expected)
            fault(block,
                  std::string(what) + ": exit " + std::to_string(result.exit) + ", expected " +
                      std::to_string(expected),
                  result.output);
    }

    void run_shell(const Block& block) const {
        const std::vector<Command> commands = commands_of(block.text);
        if (commands.empty())
            return expect_exit(block, "block", block.exit, shell("set -e\n" + block.text));

        // one shell for the block, so that `cd` and variables last; after each command its exit
        // status between separators that no output contains
        constexpr char separator = '\x1e';
        std::string script;
        for (const Command& command : commands)
            script += command.text + "\nprintf '\\036%d\\036' $?\n";
        const std::string output = shell(script).output;
        std::size_t begin = 0;
        for (const Command& command : commands) {
            const std::size_t status = output.find(separator, begin);
            if (status == std::string::npos) return fault(block, command.text, "ended the shell");
            const Result result{std::atoi(output.c_str() + status + 1),
                                output.substr(begin, status - begin)};
            begin = output.find(separator, status + 1) + 1;
            const bool last = &command == &commands.back();
            expect_exit(block, command.text, last ? block.exit : 0, result);
            if (!output_matches(command.expected, result.output))
                fault(block, command.text,
                      "expected:\n" + command.expected + "printed:\n" + result.output);
        }
    }

    void compile(const Block& block) const {
        if (block.file.empty()) {
            if (!block.fragment)
                fault(block, "a cpp block is marked with its file, or as a fragment", "");
            return;
        }
        const fs::path file = block.file;
        if (file.extension() != ".cpp") return;
        const bool program = block.text.find("int main(") != std::string::npos;
        const std::string prefix = TRELLIS_INSTALLED;
        std::string command = "$CXX $CXXFLAGS -std=c++20 -Wall -Wextra -Werror -ffp-contract=off "
                              "-I. -I " +
                              shell_word(prefix + "/include") + " -I " +
                              shell_word(prefix + "/include/trellis") + " " +
                              shell_word(block.file);
        if (program)
            command += " -o " + shell_word(fs::path(file).replace_extension().string()) + " -L " +
                       shell_word(TRELLIS_INSTALLED_LIBRARIES) +
                       " -ltrellis_bridge -ltrellis_sim -ltrellis_load -ltrellis_exec"
                       " -ltrellis_core -ltinyxml2";
        else
            command += " -fsyntax-only";
        expect_exit(block, block.file, block.exit, shell(command));
    }

    void validate(const Block& block) const {
        const bool machine = block.text.find("<scxml") != std::string::npos;
        const std::string name = "block-" + std::to_string(block.line) + "." +
                                 (machine ? std::string("scxml") : block.language);
        write(folder_ / name, block.text);
        const std::string command = "trellis validate " + name;
        expect_exit(block, command, block.exit, shell(command));
    }

    /// A fragment is well-formed: one or more elements, one JSON value.
    void parse(const Block& block) const {
        if (block.language == "json") {
            if (!nlohmann::json::accept(block.text)) fault(block, "not a JSON value", block.text);
            return;
        }
        write(base_.path() / "fragment.xml", "<fragment>\n" + block.text + "</fragment>\n");
        expect_exit(block, "xmllint", 0, shell("xmllint --noout ../fragment.xml"));
    }

    TemporaryFolder base_;
    std::string page_;
    fs::path folder_;
};

}  // namespace

// skipped unless asked for: tests/project/CMakeLists.txt makes one ctest entry per page of it
TEST_CASE("documents: every code block of every page" * doctest::skip()) {
    std::vector<fs::path> pages = files_below("docs", {".md"});
    pages.insert(pages.begin(), "README.md");
    bool found = false;  // a filter that names no page must not pass
    for (const fs::path& path : pages) {
        const std::string name = path.generic_string();
        SUBCASE(name.c_str()) {
            found = true;
            const Page page = read_page(read_file(TRELLIS_SOURCE_DIR / path));
            for (const std::string& fault : page.faults)
                FAIL_CHECK(name, ":", fault);
            PageRun run(name);
            for (const Block& block : page.blocks)
                run.run(block);
        }
    }
    CHECK_MESSAGE(found, "no such page");
}
