// Writes a grammar as XSD 1.0: a complex type for each rule, a model group for each group, a simple
// type for each form of value. Covered by tests/load/schema_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/schema_xsd.h"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>
#include <vector>

namespace trellis {

namespace {

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        default: out += c;
        }
    }
    return out;
}

/// ` name="value"`.
std::string written(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

std::string occurs(std::uint32_t least, std::uint32_t most) {
    std::string out;
    if (least != 1) { out += written("minOccurs", std::to_string(least)); }
    if (most == ElementRule::many) { return out + written("maxOccurs", "unbounded"); }
    if (most != 1) { out += written("maxOccurs", std::to_string(most)); }
    return out;
}

constexpr std::uint32_t many = ElementRule::many;

class Writer {
public:
    explicit Writer(const Grammar& grammar)
        : grammar_(grammar), machine_(grammar.kind == FileKind::machine) {}

    std::string write() {
        out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        std::string schema = " xmlns:xs=\"http://www.w3.org/2001/XMLSchema\"";
        if (machine_) {
            schema +=
                written("xmlns", scxml_namespace) + written("targetNamespace", scxml_namespace);
        }
        begin("schema", schema + " elementFormDefault=\"qualified\"");
        annotation(machine_ ? "Machine files: the part of W3C SCXML 1.0 that Trellis runs. "
                              "Generated; do not edit."
                            : "Tree files: the BehaviorTree.CPP v4 dialect with the leaves that "
                              "were registered. Generated; do not edit.");
        const ElementRule& root = grammar_.at(grammar_.root);
        line("element", written("name", root.name) + written("type", root.id));
        for (const Group& group : grammar_.groups) {
            write_group(group);
        }
        if (grammar_.nodes) { write_node_attributes(); }
        for (const ElementRule& rule : grammar_.rules) {
            write_rule(rule);
        }
        for (const auto& [name, rule] : value_types_) {
            write_value_type(name, rule);
        }
        end("schema");
        return std::move(out_);
    }

private:
    // Lines -------------------------------------------------------------------------------------

    void indent() { out_.append(2 * depth_, ' '); }
    void line(std::string_view element, const std::string& attributes) {
        indent();
        out_ += "<xs:" + std::string(element) + attributes + "/>\n";
    }
    void begin(std::string_view element, const std::string& attributes = {}) {
        indent();
        out_ += "<xs:" + std::string(element) + attributes + ">\n";
        ++depth_;
    }
    void end(std::string_view element) {
        --depth_;
        indent();
        out_ += "</xs:" + std::string(element) + ">\n";
    }
    void annotation(std::string_view doc) {
        if (doc.empty()) { return; }
        indent();
        out_ += "<xs:annotation><xs:documentation>" + escaped(doc) +
                "</xs:documentation></xs:annotation>\n";
    }

    // Elements ----------------------------------------------------------------------------------

    void write_group(const Group& group) {
        begin("group", written("name", group.id));
        begin("choice");
        for (const RuleId rule : group.rules) {
            const ElementRule& element = grammar_.at(rule);
            line("element", written("name", element.name) + written("type", element.id));
        }
        end("choice");
        end("group");
    }

    void write_rule(const ElementRule& rule) {
        begin("complexType", written("name", rule.id) + (rule.text ? " mixed=\"true\"" : ""));
        annotation(rule.doc);
        write_content(rule);
        const std::size_t common = rule.node ? grammar_.node_attributes : 0;
        for (std::size_t i = 0; i + common < rule.attributes.size(); ++i) {
            write_attribute(rule.attributes[i]);
        }
        if (rule.node) { line("attributeGroup", written("ref", "node_attributes")); }
        if (machine_) {
            line("anyAttribute", " namespace=\"##other\" processContents=\"skip\"");
        } else if (rule.open != ElementRule::Open::closed) {
            line("anyAttribute", " processContents=\"skip\"");
        }
        end("complexType");
    }

    /// What may stand inside. Machines let elements of other namespaces stand anywhere.
    void write_content(const ElementRule& rule) {
        if (rule.open == ElementRule::Open::content) {
            begin("sequence");
            line("any", " processContents=\"skip\"" + occurs(0, many));
            end("sequence");
        } else if (!machine_) {
            if (rule.group) {
                line("group",
                     written("ref", grammar_.at(rule.group).id) + occurs(rule.least, rule.most));
            }
        } else if (rule.group && rule.most == many) {
            assert(rule.least == 0 && "an element of another namespace would count");
            begin("choice", occurs(0, many));
            line("group", written("ref", grammar_.at(rule.group).id));
            line("any", " namespace=\"##other\" processContents=\"skip\"");
            end("choice");
        } else {
            write_bounded_content(rule);
        }
    }

    void write_bounded_content(const ElementRule& rule) {
        const std::string foreign =
            " namespace=\"##other\" processContents=\"skip\"" + occurs(0, many);
        begin("sequence");
        line("any", foreign);
        if (rule.group) {
            assert(rule.most == 1 && "elements of other namespaces may stand between several");
            line("group", written("ref", grammar_.at(rule.group).id) + occurs(rule.least, 1));
            line("any", foreign);
        }
        end("sequence");
    }

    // Attributes --------------------------------------------------------------------------------

    void write_node_attributes() {
        begin("attributeGroup", written("name", "node_attributes"));
        const ElementRule& node = grammar_.at(grammar_.at(grammar_.nodes).rules.front());
        for (std::size_t i = node.attributes.size() - grammar_.node_attributes;
             i < node.attributes.size(); ++i) {
            write_attribute(node.attributes[i]);
        }
        end("attributeGroup");
    }

    void write_attribute(const AttributeRule& rule) {
        std::string attributes = written("name", rule.name) + written("type", value_type(rule));
        if (rule.required) {
            attributes += written("use", "required");
        } else if (!rule.initial.empty() && accepts(rule, rule.initial)) {
            attributes += written("default", rule.initial);
        }
        std::string doc = rule.doc;
        if (!rule.unit.empty()) { doc += (doc.empty() ? "" : ", ") + ("in " + rule.unit); }
        if (doc.empty()) {
            line("attribute", attributes);
            return;
        }
        begin("attribute", attributes);
        annotation(doc);
        end("attribute");
    }

    /// The name of the simple type of such values, which is written at the end.
    std::string value_type(const AttributeRule& rule) {
        if (pattern(rule).empty()) { return "xs:string"; }
        std::string name = base_name(rule);
        if (rule.may_be_pointer && rule.type != ValueType::key) { name += "_or_key"; }
        for (const auto& known : value_types_) {
            if (known.first == name) { return name; }
        }
        value_types_.emplace_back(name, rule);
        return name;
    }
    static std::string base_name(const AttributeRule& rule) {
        switch (rule.type) {
        case ValueType::text:
        case ValueType::script:
        case ValueType::expression: break;
        case ValueType::int32:
        case ValueType::int64: return "integer";
        case ValueType::count: return "count";
        case ValueType::number: return "number";
        case ValueType::boolean: return "boolean";
        case ValueType::key: return "key";
        case ValueType::name: return "name";
        case ValueType::names: return "names";
        case ValueType::choice: {
            std::string name;
            for (const std::string& choice : rule.choices) {
                name += (name.empty() ? "" : "_or_") + choice;
            }
            return name == "1.0" ? "version" : name;
        }
        }
        return "text";
    }

    void write_value_type(const std::string& name, const AttributeRule& rule) {
        begin("simpleType", written("name", name));
        annotation(expectation_without_unit(rule));
        begin("restriction", written("base", "xs:string"));
        if (rule.type == ValueType::choice && !rule.may_be_pointer) {
            for (const std::string& choice : rule.choices) {
                line("enumeration", written("value", choice));
            }
        } else {
            line("pattern", written("value", pattern(rule)));
        }
        end("restriction");
        end("simpleType");
    }
    static std::string expectation_without_unit(AttributeRule rule) {
        rule.unit.clear();
        return expectation(rule);
    }

    const Grammar& grammar_;
    const bool machine_;
    std::vector<std::pair<std::string, AttributeRule>> value_types_;  // in order of first use
    std::string out_;
    std::size_t depth_ = 0;
};

}  // namespace

std::string xsd(const Grammar& grammar) {
    return Writer(grammar).write();
}

}  // namespace trellis
