// Collecting the palette from the grammar and the registry, and writing it.
// SPDX-License-Identifier: MIT
#include "runner/palette.h"

#include "core/program.h"
#include "load/document.h"
#include "load/grammar.h"
#include "load/xml.h"
#include "runner/json_writer.h"

#include <optional>
#include <utility>

namespace trellis {

namespace {

std::string_view type_name(ValueType type) {
    switch (type) {
    case ValueType::int32: return name_of(PortType::int32);
    case ValueType::int64:
    case ValueType::count: return name_of(PortType::int64);
    case ValueType::number: return name_of(PortType::real);
    case ValueType::boolean: return name_of(PortType::boolean);
    case ValueType::key: return name_of(PortType::any);
    case ValueType::text:
    case ValueType::name:
    case ValueType::names:
    case ValueType::script:
    case ValueType::expression:
    case ValueType::choice: break;
    }
    return name_of(PortType::text);
}

std::string_view kind_name(const OpInfo& op) {
    switch (op.group) {
    case OpGroup::control: return "Control";
    case OpGroup::decorator: return "Decorator";
    case OpGroup::action: return "Action";
    case OpGroup::condition: return "Condition";
    case OpGroup::scope: return "SubTree";
    case OpGroup::state:
    case OpGroup::pseudo:
    case OpGroup::activity: break;
    }
    return {};
}

/// The line of ops.def for a node of that name; none for what is only a spelling of others.
const OpInfo* op_called(std::string_view element) {
    for (const OpInfo& op : op_table()) {
        if (op.element == element && !element.empty()) { return &op; }
    }
    return nullptr;
}

PaletteNode built_in(const Grammar& grammar, const ElementRule& rule, const OpInfo& op) {
    PaletteNode node{kind_name(op), rule.name, rule.doc, true, {}};
    const std::size_t own = rule.attributes.size() - grammar.node_attributes;
    for (std::size_t i = 0; i < own; ++i) {
        const AttributeRule& port = rule.attributes[i];
        const bool written = port.type == ValueType::key;
        node.ports.push_back(
            {port.name, name_of(written ? PortDirection::output : PortDirection::input),
             type_name(port.type), port.unit, port.initial, port.required, port.doc});
    }
    return node;
}

std::string initial_text(const Value& value) {
    if (value.is(Value::Kind::undefined)) { return {}; }
    return value.is(Value::Kind::text) ? value.as_text() : print(value);
}

PaletteNode leaf(const LeafType& type) {
    PaletteNode node{type.condition ? "Condition" : "Action", type.name, type.doc, false, {}};
    for (const Port& port : type.ports) {
        node.ports.push_back({port.name, name_of(port.direction), name_of(port.type), port.unit,
                              initial_text(port.initial), port.required, port.doc});
    }
    return node;
}

/// "forwards, in m/s".
std::string doc_with_unit(const PalettePort& port) {
    if (port.unit.empty()) { return port.doc; }
    return port.doc.empty() ? "in " + port.unit : port.doc + ", in " + port.unit;
}

void add_node(JsonWriter& json, const PaletteNode& node) {
    json.begin_object().text("kind", node.kind).text("name", node.name);
    json.boolean("built_in", node.built_in).text("doc", node.doc).begin_array("ports");
    for (const PalettePort& port : node.ports) {
        json.begin_object().text("name", port.name).text("direction", port.direction);
        json.text("type", port.type).text("unit", port.unit).boolean("required", port.required);
        if (!port.initial.empty()) { json.text("default", port.initial); }
        json.text("doc", port.doc).end_object();
    }
    json.end_array().end_object();
}

void add_port(Document& document, ElementId parent, const PalettePort& port) {
    const ElementId e = document.open(parent, std::string(port.direction) + "_port", {});
    document.add_attribute(e, "name", port.name, {}, {});
    if (!port.type.empty()) { document.add_attribute(e, "type", port.type, {}, {}); }
    if (!port.initial.empty()) { document.add_attribute(e, "default", port.initial, {}, {}); }
    document.elements[e.index].text = document.add_string(doc_with_unit(port));
    document.close(e);
}

}  // namespace

std::vector<PaletteNode> palette(const Registry& registry) {
    const Grammar grammar = tree_grammar(registry);
    std::vector<PaletteNode> nodes;
    for (const RuleId id : grammar.at(grammar.nodes).rules) {
        const ElementRule& rule = grammar.at(id);
        const OpInfo* op = op_called(rule.name);
        if (op != nullptr) { nodes.push_back(built_in(grammar, rule, *op)); }
    }
    for (const LeafType& type : registry.leaves()) {
        nodes.push_back(leaf(type));
    }
    return nodes;
}

std::string palette_text(const Registry& registry) {
    std::string out;
    std::optional<bool> built_in;
    for (const PaletteNode& node : palette(registry)) {
        if (built_in != node.built_in) {
            if (built_in) { out += '\n'; }
            out += node.built_in ? "Built-in nodes of trees\n" : "Leaves of the Roomba\n";
            built_in = node.built_in;
        }
        out += "  " + node.name + " (" + std::string(node.kind) + "): " + node.doc + '\n';
        for (const PalettePort& port : node.ports) {
            out += "    " + port.name;
            if (!port.initial.empty()) { out += '=' + port.initial; }
            if (!port.unit.empty()) { out += ' ' + port.unit; }
            if (port.direction != name_of(PortDirection::input)) {
                out += " (" + std::string(port.direction) + ')';
            }
            if (port.required) { out += " (required)"; }
            if (!port.doc.empty()) { out += ": " + port.doc; }
            out += '\n';
        }
    }
    out += "\nSensors, in expressions\n";
    for (const Sensor& sensor : registry.host().sensors) {
        out += "  _x." + sensor.name + (sensor.unit.empty() ? "" : ' ' + sensor.unit) + ": " +
               sensor.doc + '\n';
    }
    return out;
}

std::string palette_json(const Registry& registry) {
    JsonWriter json;
    json.begin_object().begin_array("nodes");
    for (const PaletteNode& node : palette(registry)) {
        add_node(json, node);
    }
    json.end_array().begin_array("sensors");
    for (const Sensor& sensor : registry.host().sensors) {
        json.begin_object().text("name", sensor.name).text("type", name_of(sensor.type));
        json.text("unit", sensor.unit).text("doc", sensor.doc).end_object();
    }
    return std::move(json.end_array().end_object()).finish();
}

void add_models(Document& document, ElementId root, const Registry& registry) {
    const ElementId model = document.open(root, "TreeNodesModel", {});
    for (const PaletteNode& node : palette(registry)) {
        if (node.built_in) { continue; }
        const ElementId e = document.open(model, node.kind, {});
        document.add_attribute(e, "ID", node.name, {}, {});
        document.elements[e.index].doc = document.add_string(node.doc);
        for (const PalettePort& port : node.ports) {
            add_port(document, e, port);
        }
        document.close(e);
    }
    document.close(model);
}

std::string palette_xml(const Registry& registry) {
    Document document;
    const ElementId root = document.open({}, "root", {});
    document.add_attribute(root, "BTCPP_format", "4", {}, {});
    add_models(document, root, registry);
    document.close(root);
    return write_xml(document);
}

}  // namespace trellis
