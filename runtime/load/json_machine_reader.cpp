// From the JSON of a machine to its document. Covered by tests/load/json_machines_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/json_machines.h"
#include "load/json_mapping.h"
#include "load/text.h"

#include <string>
#include <vector>

namespace trellis {

namespace {

using namespace json_machines;

// The special members that each kind of object may have.
constexpr std::string_view machine_members[] = {
    "doc",     "attributes",        "text",   "xml",         "data",
    "scripts", "onentry",           "onexit", "transitions", "donedata",
    "states",  "initialTransition", "invoke"};
constexpr std::string_view state_members[] = {
    "doc",     "attributes",        "text",   "xml",         "data",
    "scripts", "onentry",           "onexit", "transitions", "donedata",
    "states",  "initialTransition", "invoke", "kind"};
constexpr std::string_view block_members[] = {"doc", "attributes", "text", "do"};
constexpr std::string_view body_members[] = {"doc", "attributes", "text", "xml"};
constexpr std::string_view content_members[] = {"doc", "attributes", "text", "xml", "scxml"};
constexpr std::string_view payload_members[] = {"doc", "attributes", "text",
                                                "xml", "params",     "content"};
constexpr std::string_view invoke_members[] = {"doc",    "attributes", "text",    "xml",
                                               "params", "content",    "finalize"};

class MachineReader {
public:
    MachineReader(const JsonTree& json, Diagnostics& diagnostics, const DocumentLimits& limits)
        : reader_(json, diagnostics, limits), json_(json) {}

    std::optional<Document> read() {
        read_state({}, json_.root(), "scxml", machine_members);
        return reader_.take();
    }

private:
    using Kind = JsonTree::Kind;
    using Read = void (MachineReader::*)(ElementId parent, JsonId value);

    // Elements ------------------------------------------------------------------------------------

    /// Opens an element for an object: its attributes, doc and text. Of the special members only
    /// the `allowed` ones may be there; the caller reads what is inside, then calls close().
    ElementId open(ElementId parent, std::string_view name, Where where, JsonId object,
                   Names allowed) {
        marks_.push_back(prefixes_.size());
        declare_prefixes(object);
        if (const JsonId nested = json_.member(object, "attributes")) { declare_prefixes(nested); }
        const Prefixed prefixed = with_prefix(name);
        const ElementId e = reader_.open(parent, prefixed.name, where);
        declare(e, prefixed, where);
        if (!parent && !json_.member(object, "xmlns")) {
            reader_.add_attribute(e, "xmlns", scxml_namespace, where);
        }
        add_members(e, object, allowed);
        return e;
    }

    /// Opens an element that has nothing but what is inside.
    ElementId open(ElementId parent, std::string_view name, JsonId value) {
        marks_.push_back(prefixes_.size());
        return reader_.open(parent, name, json_.at(value).where);
    }

    void close(ElementId e) {
        prefixes_.resize(marks_.back());
        marks_.pop_back();
        reader_.close(e);
    }

    void add_members(ElementId e, JsonId object, Names allowed) {
        bool nested = false;
        for (const JsonId m : json_.children(object)) {
            const std::string_view key = json_.key(m);
            if (is_foreign(key)) { continue; }
            if (!contains(special_members, key)) {
                add_attribute(e, m);
                nested = nested || key.starts_with('{');
            } else if (!contains(allowed, key)) {
                reader_.fail_member(m, quoted(key) + " has no meaning in <" +
                                           std::string(reader_.document().name(e)) + ">");
            } else if (key == "doc") {
                reader_.set_doc(e, m);
            } else if (key == "text" && reader_.expect(m, Kind::string)) {
                reader_.set_text(e, m);
            } else if (key == "attributes" && reader_.expect(m, Kind::object)) {
                nested = true;
                for (const JsonId inner : json_.children(m)) {
                    add_attribute(e, inner);
                }
            }
        }
        if (nested) { reader_.check_unique(e); }
    }

    void add_attribute(ElementId e, JsonId m) {
        const bool list = contains(list_attributes, json_.key(m));
        const bool array = json_.kind(m) == Kind::array;
        if (json_.kind(m) == Kind::object || (array && !list)) {
            const std::vector<std::string_view> known(std::begin(special_members),
                                                      std::end(special_members));
            reader_.fail_type(m, reader_.title(m) + " cannot be " +
                                     std::string(reader_.article(m)) + " in <" +
                                     std::string(reader_.document().name(e)) + ">" +
                                     suggestion(json_.key(m), known));
            return;
        }
        const Prefixed prefixed = with_prefix(json_.key(m));
        declare(e, prefixed, json_.at(m).key_where);
        reader_.add_attribute(e, prefixed.name, m, list);
    }

    // Namespaces ----------------------------------------------------------------------------------

    /// A name as XML writes it; `prefix` is to be declared for `uri`, unless it is empty.
    struct Prefixed {
        std::string name, prefix, uri;
    };

    /// Before any attribute is read: the one that declares a prefix may be behind its use.
    void declare_prefixes(JsonId object) {
        for (const JsonId m : json_.children(object)) {
            if (json_.key(m).starts_with("xmlns:") && json_.kind(m) == Kind::string) {
                prefixes_.declare(json_.key(m).substr(6), json_.text(m));
            }
        }
    }

    /// "{uri}local" with the prefix that stands for the namespace, or a new one; else the name.
    Prefixed with_prefix(std::string_view name) const {
        const std::size_t end = name.find('}');
        if (!name.starts_with('{') || end == std::string_view::npos) {
            return {std::string(name), {}, {}};
        }
        const std::string_view uri = name.substr(1, end - 1);
        const std::string local(name.substr(end + 1));
        const std::string_view known = prefixes_.prefix_of(uri);
        if (!known.empty()) { return {std::string(known) + ":" + local, {}, {}}; }
        std::string fresh = "ns1";
        for (int n = 2; !prefixes_.uri_of(fresh).empty(); ++n) {
            fresh = "ns" + std::to_string(n);
        }
        return {fresh + ":" + local, fresh, std::string(uri)};
    }

    void declare(ElementId e, const Prefixed& prefixed, Where where) {
        if (prefixed.prefix.empty()) { return; }
        reader_.add_attribute(e, "xmlns:" + prefixed.prefix, prefixed.uri, where);
        prefixes_.declare(prefixed.prefix, prefixed.uri);
    }

    // States --------------------------------------------------------------------------------------

    void for_each(ElementId parent, JsonId object, std::string_view key, Read read_one) {
        const JsonId list = reader_.array_member(object, key);
        if (!list) { return; }
        for (const JsonId v : json_.children(list)) {
            (this->*read_one)(parent, v);
        }
    }

    void read_state(ElementId parent, JsonId v, std::string_view name, Names allowed) {
        if (!reader_.expect(v, Kind::object)) { return; }
        const ElementId e = open(parent, name, json_.at(v).where, v, allowed);
        read_data(e, v);
        for_each(e, v, "scripts", &MachineReader::read_script);
        read_blocks(e, v, "onentry");
        read_blocks(e, v, "onexit");
        if (const JsonId initial = json_.member(v, "initialTransition")) {
            const ElementId inner = open(e, "initial", initial);
            read_transition(inner, initial);
            close(inner);
        }
        for_each(e, v, "invoke", &MachineReader::read_invoke);
        for_each(e, v, "transitions", &MachineReader::read_transition);
        if (const JsonId donedata = json_.member(v, "donedata")) {
            read_object(e, "donedata", donedata, payload_members);
        }
        for_each(e, v, "states", &MachineReader::read_substate);
        read_xml_member(e, v);
        close(e);
    }

    void read_substate(ElementId parent, JsonId v) {
        std::string_view name = "state";
        if (const JsonId kind = json_.member(v, "kind"); kind) {
            if (!reader_.expect(kind, Kind::string)) { return; }
            name = json_.text(kind);
            if (!contains(state_kinds, name)) {
                reader_.fail_type(
                    kind,
                    "\"kind\" must be \"state\", \"parallel\", \"final\" or \"history\", found " +
                        quoted(name) +
                        suggestion(name, {std::begin(state_kinds), std::end(state_kinds)}));
                return;
            }
        }
        read_state(parent, v, name, state_members);
    }

    void read_data(ElementId state, JsonId v) {
        const JsonId list = reader_.array_member(v, "data");
        if (!list) { return; }
        const ElementId e = open(state, "datamodel", list);
        for (const JsonId data : json_.children(list)) {
            read_object(e, "data", data, body_members);
        }
        close(e);
    }

    /// "onentry" and "onexit": an array of blocks, each an array of actions. Actions without an
    /// array around them are one block.
    void read_blocks(ElementId state, JsonId v, std::string_view key) {
        const JsonId list = reader_.array_member(v, key);
        if (!list) { return; }
        const bool one_block =
            json_.has_children(list) && json_.kind(*json_.children(list).begin()) == Kind::object;
        if (one_block) {
            read_block(state, key, list);
            return;
        }
        for (const JsonId block : json_.children(list)) {
            read_block(state, key, block);
        }
    }

    void read_block(ElementId parent, std::string_view name, JsonId actions) {
        if (!reader_.expect(actions, Kind::array)) { return; }
        const ElementId e = open(parent, name, actions);
        for (const JsonId action : json_.children(actions)) {
            read_action(e, action);
        }
        close(e);
    }

    void read_transition(ElementId parent, JsonId v) {
        read_object(parent, "transition", v, block_members);
    }
    void read_script(ElementId parent, JsonId v) { read_object(parent, "script", v, body_members); }
    void read_invoke(ElementId parent, JsonId v) {
        read_object(parent, "invoke", v, invoke_members);
    }
    void read_param(ElementId parent, JsonId v) { read_object(parent, "param", v, body_members); }

    /// An element with what its special members stand for, in the order of SCXML's own examples.
    void read_object(ElementId parent, std::string_view name, JsonId v, Names allowed) {
        if (!reader_.expect(v, Kind::object)) { return; }
        const bool named = json_.at(v).key_where.line != 0 && json_.key(v) == name;
        const Where where = named ? json_.at(v).key_where : json_.at(v).where;
        const ElementId e = open(parent, name, where, v, allowed);
        const auto has = [&](std::string_view key) {
            return contains(allowed, key) && json_.member(v, key);
        };
        if (has("params")) { for_each(e, v, "params", &MachineReader::read_param); }
        if (has("content")) { read_content(e, json_.member(v, "content")); }
        if (has("finalize")) { read_block(e, "finalize", json_.member(v, "finalize")); }
        if (has("do")) { for_each(e, v, "do", &MachineReader::read_action); }
        if (has("scxml")) { read_state(e, json_.member(v, "scxml"), "scxml", machine_members); }
        if (has("xml")) { read_xml_member(e, v); }
        close(e);
    }

    /// The content of a message: an object, or only its text.
    void read_content(ElementId parent, JsonId v) {
        if (json_.kind(v) != Kind::string) {
            read_object(parent, "content", v, content_members);
            return;
        }
        const ElementId e = open(parent, "content", v);
        reader_.set_text(e, v);
        close(e);
    }

    void read_xml_member(ElementId e, JsonId v) {
        if (const JsonId xml = json_.member(v, "xml")) { reader_.add_xml(e, xml); }
    }

    // Executable content --------------------------------------------------------------------------

    void read_action(ElementId parent, JsonId v) {
        if (!reader_.expect(v, Kind::object)) { return; }
        std::size_t members = 0;
        for ([[maybe_unused]] const JsonId m : json_.children(v)) {
            ++members;
        }
        if (members != 1) {
            reader_.fail_member(v, "an action has one member, such as {\"raise\": {\"event\": "
                                   "\"done\"}}, found " +
                                       std::to_string(members));
            return;
        }
        const JsonId action = *json_.children(v).begin();
        const std::string_view name = json_.key(action);
        switch (json_.kind(action)) {
        case Kind::array:
            if (name == "if") { return read_if(parent, action); }
            break;
        case Kind::object:
            return read_object(parent, name, action,
                               name == "send"     ? Names(payload_members)
                               : name == "assign" ? Names(body_members)
                                                  : Names(block_members));
        case Kind::string:
            for (const Shorthand& s : shorthands) {
                if (s.action == name) { return read_shorthand(parent, action, s); }
            }
            break;
        case Kind::null:
        case Kind::boolean:
        case Kind::number: break;
        }
        reader_.expect(action, Kind::object);
    }

    void read_shorthand(ElementId parent, JsonId action, const Shorthand& shorthand) {
        const ElementId e = reader_.open(parent, shorthand.action, json_.at(action).key_where);
        if (shorthand.attribute.empty()) {
            reader_.set_text(e, action);
        } else {
            reader_.add_attribute(e, shorthand.attribute, action);
        }
        reader_.close(e);
    }

    /// {"if": [branch, …]}: the first branch is the <if>, those behind it <elseif> or <else>
    /// inside.
    void read_if(ElementId parent, JsonId branches) {
        static constexpr std::string_view branch_members[] = {"doc", "do"};
        if (!json_.has_children(branches)) {
            reader_.fail_type(branches, "\"if\" needs at least one branch, found none");
            return;
        }
        ElementId e;
        for (const JsonId branch : json_.children(branches)) {
            if (!reader_.expect(branch, Kind::object)) { continue; }
            if (!e) {
                e = open(parent, "if", json_.at(branches).key_where, branch, branch_members);
            } else {
                const bool has_cond = static_cast<bool>(json_.member(branch, "cond"));
                close(open(e, has_cond ? "elseif" : "else", json_.at(branch).where, branch,
                           branch_members));
            }
            for_each(e, branch, "do", &MachineReader::read_action);
        }
        if (e) { close(e); }
    }

    ElementReader reader_;
    const JsonTree& json_;
    Prefixes prefixes_;
    std::vector<std::size_t> marks_;  // prefixes_.size() at the start of each open element
};

}  // namespace

std::optional<Document> machine_from_json(const JsonTree& json, Diagnostics& diagnostics,
                                          const DocumentLimits& limits) {
    return MachineReader(json, diagnostics, limits).read();
}

}  // namespace trellis
