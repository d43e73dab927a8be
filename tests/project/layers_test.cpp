// Which layer may include what: the table of the architecture, applied to every #include in
// runtime/ and sim/ (runner/ may include everything, and nothing includes runner/). It reads text,
// not the preprocessor's view: an #include under #if counts. Its own rules are tested at the end.
// SPDX-License-Identifier: MIT
#include "support/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace trellis::test;

struct Layer {
    std::string_view name;
    std::string_view folder;                    ///< from the repository's root
    std::vector<std::string_view> project;      ///< folders as they are written in an #include
    std::vector<std::string_view> third_party;  ///< prefixes; in .cpp files only
};

// A file belongs to the last layer whose folder contains it: sim/bridge is not part of sim.
const std::array layers{
    Layer{"core", "runtime/core/", {"core/"}, {}},
    Layer{"load", "runtime/load/", {"core/", "load/"}, {"tinyxml2.h", "nlohmann/"}},
    Layer{"exec", "runtime/exec/", {"core/", "exec/"}, {}},
    Layer{"sim", "sim/", {"sim/"}, {"Eigen/"}},
    Layer{"bridge", "sim/bridge/", {"core/", "load/", "exec/", "sim/"}, {"Eigen/"}},
};

// Time, random numbers and files come in through arguments; the runner has the real ones.
constexpr std::array outside_world{"atomic",       "barrier", "chrono",     "condition_variable",
                                   "csignal",      "cstdio",  "ctime",      "fcntl.h",
                                   "filesystem",   "fstream", "future",     "iostream",
                                   "latch",        "mutex",   "pthread.h",  "semaphore",
                                   "shared_mutex", "stdio.h", "stop_token", "syncstream",
                                   "thread",       "time.h",  "unistd.h"};

// Every user of a header pays for what it includes.
constexpr std::array heavy{"functional", "iostream", "map", "memory", "mutex", "regex"};

template <class Names>
bool contains(const Names& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool starts_with_any(std::string_view name, const std::vector<std::string_view>& prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](std::string_view prefix) { return name.starts_with(prefix); });
}

std::string list(const std::vector<std::string_view>& names) {
    std::string text = "the standard library";
    for (const std::string_view name : names)
        text += ", " + std::string(name);
    return text;
}

/// What `line` includes, with its opening quote or bracket ("<map", "\"core/ids.h"); empty if it is
/// not an #include.
std::string_view included(std::string_view line) {
    const auto skip_blanks = [&] {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    };
    skip_blanks();
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    skip_blanks();
    if (!line.starts_with("include")) return {};
    line.remove_prefix(7);
    skip_blanks();
    return line.substr(0, line.find_first_of(">\"", 1));
}

/// The rule that `line` of `file` (a path from the repository's root) breaks; empty if none.
std::string broken_rule(std::string_view file, std::string_view line) {
    const auto layer = std::find_if(layers.rbegin(), layers.rend(), [&](const Layer& candidate) {
        return file.starts_with(candidate.folder);
    });
    const std::string_view what = included(line);
    if (what.empty()) return {};
    if (layer == layers.rend()) return "the file belongs to no layer";

    const std::string_view name = what.substr(1);
    const std::string who(layer->name);
    if (what.front() == '"') {
        const bool allowed = starts_with_any(name, layer->project) &&
                             !(layer->name == "sim" && name.starts_with("sim/bridge/"));
        return allowed ? "" : who + " may include " + list(layer->project);
    }
    // a standard header has neither a folder nor an extension, except C's own
    const bool third_party = name.find_first_of("/.") != std::string_view::npos;
    // numbers as text need snprintf where the library has no to_chars for doubles (emscripten)
    const bool spells_numbers = file == "runtime/core/number.cpp" && name == "cstdio";
    if (contains(outside_world, name) && !spells_numbers)
        return who + " has no clock, thread, file or output";
    if (third_party && !starts_with_any(name, layer->third_party))
        return who + " may include " + list(layer->third_party);
    if (file.ends_with(".cpp")) return {};
    if (third_party) return "a header includes no third party";
    if (contains(heavy, name)) return "a header is cheap to include";
    return {};
}

}  // namespace

TEST_CASE("layers: every #include is one its layer may have") {
    for (const std::string_view folder : {"runtime", "sim"}) {
        for (const auto& file : files_below(folder, {".h", ".cpp", ".def"})) {
            const std::string text = read_file(TRELLIS_SOURCE_DIR / file);
            int number = 0;
            for (const std::string_view line : lines_of(text)) {
                ++number;
                const std::string rule = broken_rule(file.generic_string(), line);
                if (!rule.empty())
                    FAIL_CHECK(file.generic_string(), ":", number, ": ", line, ": ", rule);
            }
        }
    }
}

TEST_CASE("layers: the rules name what is wrong") {
    CHECK(broken_rule("runtime/core/a.h", "#include \"core/ids.h\"") == "");
    CHECK(broken_rule("runtime/core/a.h", "int x;  // #include <map>") == "");
    CHECK(broken_rule("runtime/core/a.h", "#include \"load/xml.h\"") ==
          "core may include the standard library, core/");
    CHECK(broken_rule("runtime/exec/a.cpp", "  #  include \"load/xml.h\"") ==
          "exec may include the standard library, core/, exec/");
    CHECK(broken_rule("runtime/load/a.cpp", "#include <tinyxml2.h>") == "");
    CHECK(broken_rule("runtime/load/a.h", "#include <tinyxml2.h>") ==
          "a header includes no third party");
    CHECK(broken_rule("runtime/core/a.cpp", "#include <nlohmann/json.hpp>") ==
          "core may include the standard library");
    CHECK(broken_rule("runtime/load/a.h", "#include <map>") == "a header is cheap to include");
    CHECK(broken_rule("runtime/load/a.cpp", "#include <map>") == "");
    CHECK(broken_rule("sim/a.cpp", "#include <chrono>") ==
          "sim has no clock, thread, file or output");
    CHECK(broken_rule("sim/a.cpp", "#include \"core/ids.h\"") ==
          "sim may include the standard library, sim/");
    CHECK(broken_rule("sim/a.cpp", "#include \"sim/bridge/leaves.h\"") ==
          "sim may include the standard library, sim/");
    CHECK(broken_rule("sim/bridge/a.cpp", "#include \"core/ids.h\"") == "");
    CHECK(broken_rule("sim/bridge/a.cpp", "#include \"runner/main.h\"") ==
          "bridge may include the standard library, core/, load/, exec/, sim/");
    CHECK(broken_rule("runtime/a.h", "#include <array>") == "the file belongs to no layer");
}
