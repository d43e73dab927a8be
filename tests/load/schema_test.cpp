// The generated schemas as texts: that each rule, leaf and port is in them, that they are stable,
// and how they are laid out. Whether they mean the same as the checks: faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/schema_json.h"
#include "load/schema_xsd.h"
#include "support/example_registry.h"

#include <doctest/doctest.h>

#include <string>

using namespace trellis;

namespace {

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

struct Schemas {
    Registry registry;
    std::string tree_xsd, machine_xsd, tree_json, machine_json;

    Schemas() {
        test::register_examples(registry);
        tree_xsd = xsd(tree_grammar(registry));
        machine_xsd = xsd(machine_grammar());
        tree_json = json_schema(tree_grammar(registry));
        machine_json = json_schema(machine_grammar());
    }
};

}  // namespace

TEST_CASE("schema: leaves and their ports are in the schemas of trees, with units and docs") {
    const Schemas schemas;
    CHECK(contains(schemas.tree_xsd,
                   "    <xs:attribute name=\"speed\" type=\"number_or_key\" default=\"0.5\">\n"
                   "      <xs:annotation><xs:documentation>forwards, in m/s</xs:documentation>"
                   "</xs:annotation>\n"
                   "    </xs:attribute>\n"));
    CHECK(contains(schemas.tree_xsd,
                   "<xs:attribute name=\"message\" type=\"xs:string\" use=\"required\">"));
    CHECK(contains(schemas.tree_json, "\"forwards, in m/s\""));
    CHECK(contains(schemas.tree_json, "\"drive straight until a time has passed\""));
}

TEST_CASE("schema: each rule has a definition") {
    const Schemas schemas;
    for (const ElementRule& rule : tree_grammar(schemas.registry).rules) {
        INFO(rule.id);
        CHECK(contains(schemas.tree_xsd, "<xs:complexType name=\"" + rule.id + "\""));
        CHECK((rule.id == "root" || contains(schemas.tree_json, "\"" + rule.id + "\": {")));
    }
    for (const ElementRule& rule : machine_grammar().rules) {
        INFO(rule.id);
        CHECK(contains(schemas.machine_xsd, "<xs:complexType name=\"" + rule.id + "\""));
    }
}

TEST_CASE("schema: what this version does not run is in no schema") {
    const Schemas schemas;
    for (const std::string& element : tree_grammar(schemas.registry).later) {
        INFO(element);
        CHECK_FALSE(contains(schemas.tree_xsd, "name=\"" + element + "\""));
        CHECK_FALSE(contains(schemas.tree_json, "\"" + element + "\""));
    }
}

TEST_CASE("schema: the same grammar gives the same text") {
    const Schemas a;
    const Schemas b;
    CHECK(a.tree_xsd == b.tree_xsd);
    CHECK(a.machine_xsd == b.machine_xsd);
    CHECK(a.tree_json == b.tree_json);
    CHECK(a.machine_json == b.machine_json);
}
