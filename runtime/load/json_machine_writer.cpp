// From the document of a machine to its JSON. Covered by tests/load/json_machines_test.cpp.
//
// Children are written kind by kind; those that have no place of their own, and those whose
// attributes or text an array cannot carry, go into "xml" as they are.
// SPDX-License-Identifier: MIT
#include "load/json_machines.h"
#include "load/json_mapping.h"
#include "load/xml.h"

#include <algorithm>
#include <string>
#include <vector>

namespace trellis {

namespace {

using namespace json_machines;

class MachineWriter {
public:
    explicit MachineWriter(const Document& document) : writer_(document), document_(document) {}

    JsonTree write() {
        write_state({}, {}, document_.root());
        return writer_.take();
    }

private:
    using Kind = JsonTree::Kind;
    using Elements = std::vector<ElementId>;

    bool has_text(ElementId e) const { return !document_.text(e).empty(); }
    bool is_leaf(ElementId e) const { return document_.child_count(e) == 0; }

    /// Whether an array can stand for the element: nothing but what is inside, where its doc goes.
    bool is_plain_list(ElementId e) const {
        return document_.at(e).attribute_count == 0 && !has_text(e) &&
               (document_.doc(e).empty() || !is_leaf(e));
    }

    /// Whether an attribute is called like a special member.
    bool has_special_attribute(ElementId e) const {
        const auto attributes = document_.attributes_of(e);
        return std::any_of(attributes.begin(), attributes.end(), [this](const Attribute& a) {
            return contains(special_members, document_.string(a.name));
        });
    }

    // Objects -------------------------------------------------------------------------------------

    /// Opens an object with the attributes, doc and text of an element. close() closes it.
    JsonId open(JsonId parent, std::string_view key, ElementId e, std::string_view kind = {}) {
        marks_.push_back(prefixes_.size());
        const JsonId object = writer_.open(parent, key, Kind::object);
        if (!kind.empty()) { writer_.add_text(object, "kind", kind); }
        writer_.add_doc(object, e);
        for (const Attribute& a : document_.attributes_of(e)) {
            const std::string_view name = document_.string(a.name);
            if (name.starts_with("xmlns:")) {
                prefixes_.declare(name.substr(6), document_.string(a.value));
            }
        }
        JsonId into = object;
        for (const Attribute& a : document_.attributes_of(e)) {
            const std::string_view name = document_.string(a.name);
            const std::string_view value = document_.string(a.value);
            // every machine is in SCXML's namespace: JSON does not say so
            if (name == "xmlns" && document_.name(e) == "scxml" && value == scxml_namespace) {
                continue;
            }
            if (into == object && contains(special_members, name)) {
                into = writer_.open(object, "attributes", Kind::object);
            }
            writer_.add_text(into, with_namespace(name), value);
        }
        if (into != object) { writer_.close(into); }
        if (has_text(e)) { writer_.add_text(object, "text", document_.text(e)); }
        return object;
    }

    void close(JsonId object) {
        prefixes_.resize(marks_.back());
        marks_.pop_back();
        writer_.close(object);
    }

    /// "{namespace}local" for "prefix:local", if a reader will choose the same prefix again.
    std::string with_namespace(std::string_view name) const {
        const std::size_t colon = name.find(':');
        if (colon == std::string_view::npos) { return std::string(name); }
        const std::string_view prefix = name.substr(0, colon);
        const std::string_view uri = prefixes_.uri_of(prefix);
        if (uri.empty() || uri.find('}') != std::string_view::npos ||
            prefixes_.prefix_of(uri) != prefix) {
            return std::string(name);
        }
        return "{" + std::string(uri) + "}" + std::string(name.substr(colon + 1));
    }

    void write_xml_member(JsonId object, const Elements& elements) {
        if (elements.empty()) { return; }
        std::string xml;
        for (const ElementId e : elements) {
            xml += write_xml(document_, e);
        }
        writer_.add_text(object, "xml", xml);
    }

    // States --------------------------------------------------------------------------------------

    /// The children of a state, kind by kind.
    struct Parts {
        Elements data_lists, scripts, onentry, onexit, invoke, transitions, states, rest;
        ElementId initial, donedata;
    };

    /// The list that a child of a state belongs into; null if it has none.
    Elements* list_for(Parts& parts, ElementId e) const {
        const std::string_view name = document_.name(e);
        if (contains(state_kinds, name)) { return &parts.states; }
        if (name == "transition") { return &parts.transitions; }
        if (name == "invoke") { return &parts.invoke; }
        if (name == "script") { return &parts.scripts; }
        if (!is_plain_list(e)) { return nullptr; }
        if (name == "onentry") { return &parts.onentry; }
        if (name == "onexit") { return &parts.onexit; }
        if (name == "datamodel" && has_only_data(e)) { return &parts.data_lists; }
        return nullptr;
    }

    bool has_only_data(ElementId datamodel) const {
        for (const ElementId e : document_.children(datamodel)) {
            if (document_.name(e) != "data") { return false; }
        }
        return true;
    }

    /// An <initial> for which "initialTransition" can stand.
    bool is_plain_initial(ElementId e) const {
        return document_.name(e) == "initial" && is_plain_list(e) &&
               document_.child_count(e) == 1 &&
               document_.name(*document_.children(e).begin()) == "transition";
    }

    Parts parts_of(ElementId state) const {
        Parts parts;
        for (const ElementId e : document_.children(state)) {
            if (Elements* const list = list_for(parts, e)) {
                list->push_back(e);
            } else if (is_plain_initial(e) && !parts.initial) {
                parts.initial = e;
            } else if (document_.name(e) == "donedata" && !parts.donedata) {
                parts.donedata = e;
            } else {
                parts.rest.push_back(e);
            }
        }
        return parts;
    }

    /// Writes an array of what `write` makes of each element; nothing if there are none.
    template <class Write>
    void write_list(JsonId object, std::string_view key, const Elements& elements, Write write) {
        if (elements.empty()) { return; }
        const JsonId list = writer_.open(object, key, Kind::array);
        for (const ElementId e : elements) {
            write(list, e);
        }
        writer_.close(list);
    }

    void write_state(JsonId parent, std::string_view key, ElementId state) {
        const std::string_view name = document_.name(state);
        const bool named = name != "scxml" && name != "state";
        const JsonId object = open(parent, key, state, named ? name : std::string_view());
        const Parts parts = parts_of(state);
        const auto body = [this](JsonId list, ElementId e) { write_body(list, {}, e); };
        const auto block = [this](JsonId list, ElementId e) { write_block(list, {}, e); };

        write_data(object, parts.data_lists);
        write_list(object, "scripts", parts.scripts, body);
        write_list(object, "onentry", parts.onentry, block);
        write_list(object, "onexit", parts.onexit, block);
        if (parts.initial) {
            writer_.carry_doc(parts.initial);
            write_with_actions(object, "initialTransition",
                               *document_.children(parts.initial).begin());
        }
        write_list(object, "invoke", parts.invoke,
                   [this](JsonId list, ElementId e) { write_payload(list, {}, e); });
        write_list(object, "transitions", parts.transitions,
                   [this](JsonId list, ElementId e) { write_with_actions(list, {}, e); });
        if (parts.donedata) { write_payload(object, "donedata", parts.donedata); }
        write_list(object, "states", parts.states,
                   [this](JsonId list, ElementId e) { write_state(list, {}, e); });
        write_xml_member(object, parts.rest);
        close(object);
    }

    /// All the <data> of a state: several <datamodel> become one array.
    void write_data(JsonId object, const Elements& lists) {
        if (lists.empty()) { return; }
        const JsonId array = writer_.open(object, "data", Kind::array);
        for (const ElementId list : lists) {
            writer_.carry_doc(list);
            for (const ElementId e : document_.children(list)) {
                write_body(array, {}, e);
            }
        }
        writer_.close(array);
    }

    /// An element whose children, if any, are not SCXML: <data>, <assign>, <param>, <script>.
    void write_body(JsonId parent, std::string_view key, ElementId e) {
        const JsonId object = open(parent, key, e);
        Elements children;
        for (const ElementId child : document_.children(e)) {
            children.push_back(child);
        }
        write_xml_member(object, children);
        close(object);
    }

    void write_content(JsonId parent, ElementId e) {
        const bool machine = document_.child_count(e) == 1 &&
                             document_.name(*document_.children(e).begin()) == "scxml";
        if (!machine) {
            write_body(parent, "content", e);
            return;
        }
        const JsonId object = open(parent, "content", e);
        write_state(object, "scxml", *document_.children(e).begin());
        close(object);
    }

    /// What is sent or passed on: <send>, <invoke>, <donedata>.
    void write_payload(JsonId parent, std::string_view key, ElementId e) {
        Elements params, rest;
        ElementId content, finalize;
        for (const ElementId child : document_.children(e)) {
            const std::string_view name = document_.name(child);
            if (name == "param") {
                params.push_back(child);
            } else if (name == "content" && !content) {
                content = child;
            } else if (name == "finalize" && document_.name(e) == "invoke" && !finalize &&
                       is_plain_list(child)) {
                finalize = child;
            } else {
                rest.push_back(child);
            }
        }
        const JsonId object = open(parent, key, e);
        write_list(object, "params", params,
                   [this](JsonId list, ElementId param) { write_body(list, {}, param); });
        if (content) { write_content(object, content); }
        if (finalize) { write_block(object, "finalize", finalize); }
        write_xml_member(object, rest);
        close(object);
    }

    // Executable content --------------------------------------------------------------------------

    /// A container of actions as an array.
    void write_block(JsonId parent, std::string_view key, ElementId e) {
        writer_.carry_doc(e);
        const JsonId list = writer_.open(parent, key, Kind::array);
        for (const ElementId action : document_.children(e)) {
            write_action(list, action);
        }
        writer_.close(list);
    }

    /// An element with actions inside: <transition>, <foreach>, actions that SCXML does not know.
    void write_with_actions(JsonId parent, std::string_view key, ElementId e) {
        const JsonId object = open(parent, key, e);
        if (!is_leaf(e)) {
            const JsonId list = writer_.open(object, "do", Kind::array);
            for (const ElementId action : document_.children(e)) {
                write_action(list, action);
            }
            writer_.close(list);
        }
        close(object);
    }

    void write_action(JsonId list, ElementId e) {
        const std::string_view name = document_.name(e);
        const JsonId action = writer_.open(list, {}, Kind::object);
        if (name == "if" && has_branches(e)) {
            write_if(action, e);
        } else if (name == "send") {
            write_payload(action, name, e);
        } else if (name == "assign") {
            write_body(action, name, e);
        } else {
            write_with_actions(action, name, e);
        }
        writer_.close(action);
    }

    bool is_branch(ElementId e) const {
        return document_.name(e) == "elseif" || document_.name(e) == "else";
    }

    /// Whether the form with an array of branches says all that the <if> says.
    bool has_branches(ElementId e) const {
        if (has_text(e) || has_special_attribute(e)) { return false; }
        for (const ElementId child : document_.children(e)) {
            if (!is_branch(child)) { continue; }
            const bool has_cond = document_.find(child, "cond") != nullptr;
            if (has_text(child) || !is_leaf(child) || has_special_attribute(child) ||
                has_cond != (document_.name(child) == "elseif")) {
                return false;
            }
        }
        return true;
    }

    void write_if(JsonId action, ElementId e) {
        const JsonId branches = writer_.open(action, "if", Kind::array);
        JsonId branch = open(branches, {}, e);
        JsonId actions = writer_.open(branch, "do", Kind::array);
        for (const ElementId child : document_.children(e)) {
            if (!is_branch(child)) {
                write_action(actions, child);
                continue;
            }
            writer_.close(actions);
            close(branch);
            branch = open(branches, {}, child);
            actions = writer_.open(branch, "do", Kind::array);
        }
        writer_.close(actions);
        close(branch);
        writer_.close(branches);
    }

    ElementWriter writer_;
    const Document& document_;
    Prefixes prefixes_;
    std::vector<std::size_t> marks_;  // prefixes_.size() at the start of each open object
};

}  // namespace

JsonTree machine_to_json(const Document& document) {
    return MachineWriter(document).write();
}

}  // namespace trellis
