// The corpus tests/faults: every finding about every faulty file, and that XML Schema and JSON
// Schema validators, which know nothing of our code, call the same files valid as we do; also on
// random mutations. TRELLIS_UPDATE_GOLDENS=1 rewrites the expected findings, TRELLIS_MUTATIONS=5000
// judges more than 500.
// SPDX-License-Identifier: MIT
#include "load/grammar.h"
#include "load/mutations.h"
#include "load/schema_json.h"
#include "load/schema_xsd.h"
#include "support/diagnose.h"
#include "support/example_registry.h"
#include "support/files.h"
#include "support/judges.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <string>

using namespace trellis;
using namespace trellis::test;
namespace fs = std::filesystem;

namespace {

/// The behaviour files of a folder of the repository.
Paths behaviours(std::string_view folder) {
    Paths out;
    for (const fs::path& file : files_below(folder, {".xml", ".scxml", ".json"})) {
        out.push_back(fs::path(TRELLIS_SOURCE_DIR) / file);
    }
    return out;
}

const Registry& examples() {
    static Registry registry;
    static const bool registered = (register_examples(registry), true);
    static_cast<void>(registered);
    return registry;
}

Findings diagnose_file(const fs::path& file) {
    return diagnose(file.filename().string(), read_file(file), examples());
}

/// Every id of load/diagnostic_ids.def.
std::set<std::string> known_ids() {
    return {
#define DIAGNOSTIC(id, meaning) id,
#include "load/diagnostic_ids.def"
    };
}

/// Files on which a schema must differ from us, and why.
const std::map<std::string, std::string>& exceptions() {
    static const std::map<std::string, std::string> list = {
        {"tree_doctype.xml", "xmllint reads document type definitions; we refuse them"},
        {"tree_utf16.xml", "xmllint reads UTF-16; we refuse it"},
        {"tree_duplicate_member.json", "Python's json takes the last of equal members"},
        {"machine_duplicate_member.json", "Python's json takes the last of equal members"},
    };
    return list;
}

/// What a schema should say of a text: an XSD cannot let unknown names pass that begin with _,
/// about which we warn.
bool should_be_invalid(const Findings& findings, bool json) {
    const auto& all = findings.diagnostics.all();
    const bool ignored = std::any_of(
        all.begin(), all.end(), [](const Diagnostic& d) { return d.id == "ignored-attribute"; });
    return findings.invalid() || (ignored && !json);
}

/// The schemas of both kinds of file in both languages, and the validators on them.
class Judges {
public:
    Judges() {
        const Grammar trees = tree_grammar(examples());
        const Grammar machines = machine_grammar();
        tree_xsd_ = scratch.write("tree.xsd", xsd(trees));
        machine_xsd_ = scratch.write("machine.xsd", xsd(machines));
        tree_json_ = scratch.write("tree.schema.json", json_schema(trees));
        machine_json_ = scratch.write("machine.schema.json", json_schema(machines));
    }

    ScratchFolder scratch;

    /// Compares the verdicts on the files; returns how many were judged.
    std::size_t compare(const Paths& files) {
        std::map<const fs::path*, Paths> by_schema;
        std::map<fs::path, std::string> ours;  // why invalid; empty: valid
        for (const fs::path& file : files) {
            const Findings findings = diagnose_file(file);
            const bool machine =
                findings.readable ? findings.kind == FileKind::machine
                                  : file.filename().string().find("machine") != std::string::npos;
            const bool json = file.extension() == ".json";
            by_schema[json ? (machine ? &machine_json_ : &tree_json_)
                           : (machine ? &machine_xsd_ : &tree_xsd_)]
                .push_back(file);
            ours[file] = should_be_invalid(findings, json) ? findings.diagnostics.render() : "";
        }
        std::size_t judged = 0;
        for (const auto& [schema, group] : by_schema) {
            const bool json = schema->extension() == ".json";
            const auto valid =
                json ? valid_by_jsonschema(*schema, group) : valid_by_xmllint(*schema, group);
            if (!valid) {
                MESSAGE((json ? "Python's jsonschema" : "xmllint"),
                        " is not installed: not judged");
                continue;
            }
            for (const fs::path& file : group) {
                if (exceptions().count(file.filename().string()) != 0) { continue; }
                ++judged;
                const bool theirs = valid->count(file) != 0;
                if (theirs == ours[file].empty()) { continue; }
                FAIL_CHECK(file.filename().string()
                           << ": the schema says " << std::string(theirs ? "valid" : "invalid")
                           << ", we say "
                           << (ours[file].empty() ? std::string("valid") : ours[file]) << "\n"
                           << read_file(file));
            }
        }
        return judged;
    }

private:
    fs::path tree_xsd_, machine_xsd_, tree_json_, machine_json_;
};

/// The first line in which two texts differ.
std::string difference(const std::string& expected, const std::string& found) {
    const auto a = lines_of(expected);
    const auto b = lines_of(found);
    std::size_t i = 0;
    while (i < a.size() && i < b.size() && a[i] == b[i]) {
        ++i;
    }
    const auto line = [&](const auto& lines) {
        return i < lines.size() ? std::string(lines[i]) : std::string("(no more lines)");
    };
    return "line " + std::to_string(i + 1) + "\n  expected: " + line(a) +
           "\n  found:    " + line(b);
}

}  // namespace

TEST_CASE("faults: each file has exactly the findings that stand beside it") {
    const bool update = std::getenv("TRELLIS_UPDATE_GOLDENS") != nullptr;
    for (const fs::path& file : behaviours("tests/faults")) {
        const std::string found = diagnose_file(file).diagnostics.render();
        const std::string name = file.filename().string();
        if (name.starts_with("good_")) {
            CHECK_MESSAGE(found.empty(), name, ":\n", found);
            continue;
        }
        const fs::path golden = file.string() + ".expected";
        if (update) {
            std::ofstream(golden, std::ios::binary) << found;
            continue;
        }
        REQUIRE_MESSAGE(fs::exists(golden), golden.string(),
                        " is missing: run with TRELLIS_UPDATE_GOLDENS=1");
        const std::string expected = read_file(golden);
        CHECK_MESSAGE(found == expected, name, ", ", difference(expected, found));
    }
}

TEST_CASE("faults: every finding has an id of the table, and every id of check.cpp is found") {
    const std::set<std::string> known = known_ids();
    std::set<std::string> seen;
    for (const fs::path& file : behaviours("tests/faults")) {
        const Findings findings = diagnose_file(file);
        for (const Diagnostic& d : findings.diagnostics.all()) {
            seen.insert(d.id);
            CHECK_MESSAGE(known.count(d.id) != 0, d.id, " is not in diagnostic_ids.def");
        }
    }
    for (const char* id :
         {"wrong-root", "wrong-namespace", "unknown-node", "unknown-element", "misplaced-element",
          "unknown-attribute", "missing-attribute", "bad-value", "child-count", "unexpected-text",
          "ignored-attribute", "format-version", "out-of-range", "missing-part",
          "conflicting-parts", "branch-after-else"}) {
        CHECK_MESSAGE(seen.count(id) != 0, id, " is found in no file");
    }
}

TEST_CASE("faults: independent validators call the same files valid") {
    Judges judges;
    const std::size_t judged = judges.compare(behaviours("tests/faults"));
    CHECK((judged == 0 || judged > 180));
    judges.compare(behaviours("trees"));
    judges.compare(behaviours("machines"));
}

TEST_CASE("faults: independent validators agree on random mutations") {
    Judges judges;
    Paths seeds;
    for (const std::string_view folder : {"tests/faults", "trees", "machines"}) {
        for (const fs::path& file : behaviours(folder)) {
            if (!diagnose_file(file).invalid()) { seeds.push_back(file); }
        }
    }
    test::Random random(1);
    Paths mutants;
    const char* count = std::getenv("TRELLIS_MUTATIONS");
    const int mutations = count != nullptr ? std::atoi(count) : 500;
    for (int i = 0; i < mutations; ++i) {
        const fs::path& seed = seeds[random.below(static_cast<std::uint32_t>(seeds.size()))];
        const bool json = seed.extension() == ".json";
        const std::string text = read_file(seed);
        mutants.push_back(
            judges.scratch.write(std::to_string(i) + "_" + seed.filename().string(),
                                 json ? mutated_json(text, random) : mutated_xml(text, random)));
    }
    judges.compare(mutants);
}
