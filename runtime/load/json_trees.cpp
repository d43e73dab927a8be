// The JSON of tree files (../shared/TREES.md, "JSON"): one object per node, one array per kind of
// child of the root. Covered by tests/load/json_trees_test.cpp.
//
// Every element can be written as a node, {"type": name, …}; the outer elements of the dialect have
// shorter forms, and fall back to a node when something in them has no place there.
// SPDX-License-Identifier: MIT
#include "load/json_mapping.h"
#include "load/text.h"

#include <algorithm>
#include <string>

namespace trellis {

namespace {

// Members that are no attributes. An attribute that is called like one of them, and those behind
// it, are written inside "ports".
constexpr std::string_view node_members[] = {"type", "doc", "children", "ports"};
constexpr std::string_view tree_members[] = {"type", "doc", "children", "ports", "root"};
constexpr std::string_view root_members[] = {"doc", "ports", "include", "trees", "models", "extra"};
constexpr std::string_view model_members[] = {"type", "doc", "kind", "ports"};
constexpr std::string_view port_members[] = {"doc", "direction", "description"};
constexpr std::string_view directions[] = {"input", "output", "inout"};
constexpr std::string_view port_suffix = "_port";

class TreeReader {
public:
    TreeReader(const JsonTree& json, Diagnostics& diagnostics, const DocumentLimits& limits)
        : reader_(json, diagnostics, limits), json_(json) {}

    std::optional<Document> read() {
        const JsonId file = json_.root();
        if (!reader_.expect(file, Kind::object)) { return std::nullopt; }
        const ElementId root = reader_.open({}, "root", json_.at(file).where);
        add_members(root, file, root_members);
        const JsonId extra = reader_.array_member(file, "extra");
        if (extra) { reader_.set_text(root, extra); }
        for_each(file, "include", [&](JsonId v) { read_include(v, root); });
        for_each(file, "trees", [&](JsonId v) { read_tree(v, root); });
        read_models(file, root);
        if (extra) { read_children(extra, root); }
        reader_.close(root);
        return reader_.take();
    }

private:
    using Kind = JsonTree::Kind;

    /// Calls `read` for each value of an array that is a member of `object`.
    template <class Read>
    void for_each(JsonId object, std::string_view key, Read read) {
        const JsonId list = json_.member(object, key);
        if (!list) { return; }
        if (json_.kind(list) == Kind::string && key == "include") {
            read(list);
        } else if (reader_.expect(list, Kind::array)) {
            for (const JsonId v : json_.children(list)) {
                read(v);
            }
        }
    }

    /// The attributes and the doc of an element; `special` members mean something else.
    void add_members(ElementId e, JsonId object, Names special) {
        bool nested = false;
        for (const JsonId m : json_.children(object)) {
            const std::string_view key = json_.key(m);
            if (is_foreign(key)) { continue; }
            if (!contains(special, key)) {
                reader_.add_attribute(e, key, m);
            } else if (key == "doc") {
                reader_.set_doc(e, m);
            } else if (key == "ports" && reader_.expect(m, Kind::object)) {
                nested = true;
                for (const JsonId port : json_.children(m)) {
                    reader_.add_attribute(e, json_.key(port), port);
                }
            }
        }
        if (nested) { reader_.check_unique(e); }
    }

    void read_node(JsonId v, ElementId parent) {
        if (!reader_.expect(v, Kind::object)) { return; }
        const JsonId type = json_.member(v, "type");
        if (!type) {
            reader_.fail_member(v, "a node needs a \"type\", such as {\"type\": \"Sequence\"}");
            return;
        }
        if (!reader_.expect(type, Kind::string)) { return; }
        const ElementId e = reader_.open(parent, json_.text(type), json_.at(type).where);
        add_members(e, v, node_members);
        if (const JsonId children = reader_.array_member(v, "children")) {
            reader_.set_text(e, children);
            read_children(children, e);
        }
        reader_.close(e);
    }

    /// The nodes of an array; pieces of text in it are the parent's.
    void read_children(JsonId children, ElementId parent) {
        for (const JsonId child : json_.children(children)) {
            if (json_.kind(child) != Kind::string) { read_node(child, parent); }
        }
    }

    bool is_node(JsonId v) const { return static_cast<bool>(json_.member(v, "type")); }

    void read_include(JsonId v, ElementId root) {
        if (is_node(v)) {
            read_node(v, root);
            return;
        }
        const ElementId e = reader_.open(root, "include", json_.at(v).where);
        if (json_.kind(v) == Kind::string) {
            reader_.add_attribute(e, "path", v);
        } else if (reader_.expect(v, Kind::object)) {
            add_members(e, v, node_members);
        }
        reader_.close(e);
    }

    void read_tree(JsonId v, ElementId root) {
        if (is_node(v)) {
            read_node(v, root);
            return;
        }
        if (!reader_.expect(v, Kind::object)) { return; }
        const ElementId e = reader_.open(root, "BehaviorTree", json_.at(v).where);
        add_members(e, v, tree_members);
        const JsonId children = reader_.array_member(v, "children");
        const JsonId node = json_.member(v, "root");
        if (children) { reader_.set_text(e, children); }
        if (node) { read_node(node, e); }
        if (children) { read_children(children, e); }
        reader_.close(e);
    }

    void read_models(JsonId file, ElementId root) {
        const JsonId models = json_.member(file, "models");
        if (!models) { return; }
        const ElementId e = reader_.open(root, "TreeNodesModel", json_.at(models).key_where);
        for_each(file, "models", [&](JsonId v) { read_model(v, e); });
        reader_.close(e);
    }

    void read_model(JsonId v, ElementId parent) {
        if (is_node(v)) {
            read_node(v, parent);
            return;
        }
        if (!reader_.expect(v, Kind::object)) { return; }
        const JsonId kind = json_.member(v, "kind");
        if (!kind) {
            reader_.fail_member(v,
                                "a model needs a \"kind\": Action, Condition, Control, Decorator "
                                "or SubTree");
            return;
        }
        if (!reader_.expect(kind, Kind::string)) { return; }
        const ElementId e = reader_.open(parent, json_.text(kind), json_.at(kind).where);
        for (const JsonId m : json_.children(v)) {
            if (json_.key(m) == "doc") { reader_.set_doc(e, m); }
            if (!contains(model_members, json_.key(m))) {
                reader_.add_attribute(e, json_.key(m), m);
            }
        }
        for_each(v, "ports", [&](JsonId port) { read_port(port, e); });
        reader_.close(e);
    }

    void read_port(JsonId v, ElementId model) {
        if (!reader_.expect(v, Kind::object)) { return; }
        const JsonId direction = json_.member(v, "direction");
        if (!direction) {
            reader_.fail_member(v, "a port needs a \"direction\": input, output or inout");
            return;
        }
        const std::string_view name = json_.text(direction);
        if (json_.kind(direction) != Kind::string || !contains(directions, name)) {
            reader_.fail_type(direction,
                              "\"direction\" must be \"input\", \"output\" or \"inout\"");
            return;
        }
        const ElementId e = reader_.open(model, std::string(name) + std::string(port_suffix),
                                         json_.at(direction).where);
        for (const JsonId m : json_.children(v)) {
            const std::string_view key = json_.key(m);
            if (key == "doc") {
                reader_.set_doc(e, m);
            } else if (key == "description") {
                reader_.set_text(e, m);
            } else if (!contains(port_members, key)) {
                reader_.add_attribute(e, key, m);
            }
        }
        reader_.close(e);
    }

    ElementReader reader_;
    const JsonTree& json_;
};

class TreeWriter {
public:
    explicit TreeWriter(const Document& document) : writer_(document), document_(document) {}

    JsonTree write() {
        const ElementId root = document_.root();
        sort_children(root);
        const JsonId file = writer_.open({}, {}, Kind::object);
        add_attributes(file, root, root_members);
        writer_.add_doc(file, root);
        write_list(file, "include", includes_,
                   [&](JsonId in, ElementId e) { write_include(in, e); });
        write_list(file, "trees", trees_, [&](JsonId in, ElementId e) { write_tree(in, e); });
        if (model_list_) {
            writer_.carry_doc(model_list_);
            const JsonId list = writer_.open(file, "models", Kind::array);
            for (const ElementId e : document_.children(model_list_)) {
                write_model(list, e);
            }
            writer_.close(list);
        }
        if (!extra_.empty() || !document_.text(root).empty()) {
            const JsonId list = writer_.open(file, "extra", Kind::array);
            if (!document_.text(root).empty()) { writer_.add_text(list, {}, document_.text(root)); }
            for (const ElementId e : extra_) {
                write_node(list, {}, e);
            }
            writer_.close(list);
        }
        writer_.close(file);
        return writer_.take();
    }

private:
    using Kind = JsonTree::Kind;

    void sort_children(ElementId root) {
        for (const ElementId e : document_.children(root)) {
            const std::string_view name = document_.name(e);
            if (name == "include") {
                includes_.push_back(e);
            } else if (name == "BehaviorTree") {
                trees_.push_back(e);
            } else if (name == "TreeNodesModel" && !model_list_ && is_plain_list(e)) {
                model_list_ = e;
            } else {
                extra_.push_back(e);
            }
        }
    }

    /// Whether the array can stand for the element: its doc moves to the first thing inside.
    bool is_plain_list(ElementId e) const {
        return document_.at(e).attribute_count == 0 && document_.text(e).empty() &&
               (document_.doc(e).empty() || document_.child_count(e) != 0);
    }

    template <class Write>
    void write_list(JsonId object, std::string_view key, const std::vector<ElementId>& elements,
                    Write write) {
        if (elements.empty()) { return; }
        const JsonId list = writer_.open(object, key, Kind::array);
        for (const ElementId e : elements) {
            write(list, e);
        }
        writer_.close(list);
    }

    bool has_attribute_among(ElementId e, Names names) const {
        return std::any_of(
            document_.attributes_of(e).begin(), document_.attributes_of(e).end(),
            [&](const Attribute& a) { return contains(names, document_.string(a.name)); });
    }

    /// All attributes as members; from the first on that is called like a special member, inside
    /// "ports", so that they keep their order.
    void add_attributes(JsonId object, ElementId e, Names special) {
        JsonId into = object;
        for (const Attribute& a : document_.attributes_of(e)) {
            const std::string_view name = document_.string(a.name);
            if (into == object && contains(special, name)) {
                into = writer_.open(object, "ports", Kind::object);
            }
            writer_.add_bare(into, name, document_.string(a.value));
        }
        if (into != object) { writer_.close(into); }
    }

    void write_node(JsonId parent, std::string_view key, ElementId e) {
        const JsonId object = writer_.open(parent, key, Kind::object);
        writer_.add_text(object, "type", document_.name(e));
        writer_.add_doc(object, e);
        add_attributes(object, e, node_members);
        write_children(object, e);
        writer_.close(object);
    }

    /// "children": the text, if any, then the nodes; nothing if there are none.
    void write_children(JsonId object, ElementId e) {
        const std::string_view text = document_.text(e);
        if (text.empty() && document_.child_count(e) == 0) { return; }
        const JsonId list = writer_.open(object, "children", Kind::array);
        if (!text.empty()) { writer_.add_text(list, {}, text); }
        for (const ElementId child : document_.children(e)) {
            write_node(list, {}, child);
        }
        writer_.close(list);
    }

    void write_include(JsonId list, ElementId e) {
        const bool leaf = document_.child_count(e) == 0 && document_.text(e).empty();
        if (!leaf || has_attribute_among(e, node_members)) {
            write_node(list, {}, e);
            return;
        }
        const bool only_path = document_.at(e).attribute_count == 1 &&
                               document_.find(e, "path") != nullptr && document_.doc(e).empty();
        if (only_path) {
            writer_.add_text(list, {}, document_.value(e, "path"));
            return;
        }
        const JsonId object = writer_.open(list, {}, Kind::object);
        add_attributes(object, e, node_members);
        writer_.add_doc(object, e);
        writer_.close(object);
    }

    void write_tree(JsonId list, ElementId e) {
        const JsonId object = writer_.open(list, {}, Kind::object);
        add_attributes(object, e, tree_members);
        writer_.add_doc(object, e);
        if (document_.text(e).empty() && document_.child_count(e) == 1) {
            write_node(object, "root", *document_.children(e).begin());
        } else {
            write_children(object, e);
        }
        writer_.close(object);
    }

    /// The direction of a port that has a short form: "input" of <input_port>; empty if it has
    /// none.
    std::string_view direction(ElementId port) const {
        std::string_view name = document_.name(port);
        if (!name.ends_with(port_suffix) || document_.child_count(port) != 0 ||
            has_attribute_among(port, port_members)) {
            return {};
        }
        name.remove_suffix(port_suffix.size());
        return contains(directions, name) ? name : std::string_view();
    }

    void write_model(JsonId list, ElementId e) {
        bool has_form = document_.text(e).empty() && !has_attribute_among(e, model_members);
        for (const ElementId port : document_.children(e)) {
            has_form = has_form && !direction(port).empty();
        }
        if (!has_form) {
            write_node(list, {}, e);
            return;
        }
        const JsonId object = writer_.open(list, {}, Kind::object);
        writer_.add_text(object, "kind", document_.name(e));
        for (const Attribute& a : document_.attributes_of(e)) {
            writer_.add_bare(object, document_.string(a.name), document_.string(a.value));
        }
        writer_.add_doc(object, e);
        if (document_.child_count(e) != 0) {
            const JsonId ports = writer_.open(object, "ports", Kind::array);
            for (const ElementId port : document_.children(e)) {
                write_port(ports, port);
            }
            writer_.close(ports);
        }
        writer_.close(object);
    }

    void write_port(JsonId list, ElementId e) {
        const JsonId object = writer_.open(list, {}, Kind::object);
        writer_.add_text(object, "direction", direction(e));
        for (const Attribute& a : document_.attributes_of(e)) {
            writer_.add_text(object, document_.string(a.name), document_.string(a.value));
        }
        if (!document_.text(e).empty()) {
            writer_.add_text(object, "description", document_.text(e));
        }
        writer_.add_doc(object, e);
        writer_.close(object);
    }

    ElementWriter writer_;
    const Document& document_;
    std::vector<ElementId> includes_, trees_, extra_;
    ElementId model_list_;  // the element that "models" stands for
};

}  // namespace

std::optional<Document> tree_from_json(const JsonTree& json, Diagnostics& diagnostics,
                                       const DocumentLimits& limits) {
    return TreeReader(json, diagnostics, limits).read();
}

JsonTree tree_to_json(const Document& document) {
    return TreeWriter(document).write();
}

}  // namespace trellis
