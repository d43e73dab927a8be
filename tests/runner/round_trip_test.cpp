// What fmt and convert hold for every file: laid out once it stays so, in either spelling, and the
// way through JSON and back gives the same text, with all that editors write.
// SPDX-License-Identifier: MIT
#include "load/load.h"
#include "runner/command.h"
#include "runner/respelled.h"
#include "support/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

using namespace trellis;
using namespace trellis::test;

namespace {

namespace fs = std::filesystem;
using Spelling = Document::Spelling;

/// The text as fmt lays it out in that spelling; empty if it is no behaviour or would say less.
std::string laid_out(const std::string& text, Spelling spelling) {
    Diagnostics diagnostics;
    const std::optional<Document> document = read({"file", text}, diagnostics);
    if (!document || !file_kind(*document)) { return {}; }
    return respelled(*document, *file_kind(*document), spelling).value_or("");
}

/// Trees and machines below a folder, in order: of those in `faults` the good ones, and not the one
/// that is nested too deeply to be read.
std::vector<fs::path> behaviours(const fs::path& folder) {
    std::vector<fs::path> out;
    if (!fs::exists(folder)) { return out; }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path& path = entry.path();
        const std::string name = path.filename().string();
        const bool good = folder.filename() != "faults" || name.starts_with("good_");
        const std::string ending = path.extension().string();
        if (name == "xml_depth_300.xml") { continue; }
        if (good && (ending == ".xml" || ending == ".scxml" || ending == ".json")) {
            out.push_back(path);
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

TEST_CASE("round trip: laid out once a file stays so, and JSON keeps all of it") {
    std::vector<fs::path> paths;
    for (const fs::path& folder :
         {fs::path(from_root("trees")), fs::path(from_root("machines")),
          fs::path(from_root("tests/faults")), fs::path(TRELLIS_CONFORMANCE_DIR) / "trees"}) {
        const std::vector<fs::path> found = behaviours(folder);
        if (found.empty()) { MESSAGE("no behaviours in " << folder.string()); }
        paths.insert(paths.end(), found.begin(), found.end());
    }
    for (const fs::path& path : paths) {
        INFO(path.string());
        const std::string text = read_file(path);
        const std::string xml = laid_out(text, Spelling::xml);
        const std::string json = laid_out(text, Spelling::json);
        CHECK(!xml.empty());
        CHECK(!json.empty());
        CHECK(laid_out(xml, Spelling::xml) == xml);
        CHECK(laid_out(json, Spelling::json) == json);
        CHECK(laid_out(xml, Spelling::json) == json);
        CHECK(laid_out(laid_out(json, Spelling::xml), Spelling::json) == json);
    }
}

TEST_CASE("round trip: what Groot2 writes comes back from JSON as it was") {
    const std::string groot = read_file(from_root("tests/faults/good_tree_groot2.xml"));
    const std::string xml = laid_out(groot, Spelling::xml);
    CHECK(xml == groot);
    CHECK(laid_out(laid_out(groot, Spelling::json), Spelling::xml) == groot);
}
