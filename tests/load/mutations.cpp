// One change to a document or a JSON value. Used by faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/mutations.h"

#include "load/document.h"
#include "load/xml.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace trellis::test {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* values[] = {"", "x", "5", "-1.5", "{v}", "true", "a b", "tick", "{}", "1e3"};
constexpr const char* names[] = {"Sequence", "Repeat",     "Say",   "Bumped",  "state", "final",
                                 "onentry",  "transition", "data",  "log",     "raise", "invoke",
                                 "name",     "event",      "speed", "message", "type",  "id",
                                 "_skipIf",  "unknown",    "else",  "param",   "ID",    "expr"};

template <std::size_t n>
const char* one_of(const char* const (&list)[n], Random& random) {
    return list[random.below(static_cast<std::uint32_t>(n))];
}

/// What is done to one element while the document is copied.
enum class Change { name, add_attribute, drop_attribute, attribute_name, value, child, drop, text };
constexpr std::uint32_t changes = 8;

class XmlMutation {
public:
    XmlMutation(const Document& from, Random& random)
        : from_(from),
          random_(random), at_{random.below(static_cast<std::uint32_t>(from.elements.size()))},
          change_(static_cast<Change>(random.below(changes))) {}

    std::string write() {
        copy(from_.root(), {});
        return write_xml(to_);
    }

private:
    void copy(ElementId e, ElementId parent) {
        const bool here = e == at_;
        if (here && change_ == Change::drop && parent) { return; }
        const std::string name(here && change_ == Change::name ? one_of(names, random_)
                                                               : from_.name(e));
        const ElementId out = to_.open(parent, name, {});
        copy_attributes(e, out, here);
        if (!from_.text(e).empty()) { set_text(out, from_.text(e)); }
        if (here && change_ == Change::text) { set_text(out, "stray"); }
        if (here && change_ == Change::child) {
            const ElementId other{random_.below(static_cast<std::uint32_t>(from_.elements.size()))};
            copy_subtree(from_, other, to_, out);
        }
        for (const ElementId child : from_.children(e)) {
            copy(child, out);
        }
        to_.close(out);
    }

    void copy_attributes(ElementId e, ElementId out, bool here) {
        const std::uint32_t count = from_.at(e).attribute_count;
        const std::uint32_t chosen = count == 0 ? 0 : random_.below(count);
        std::uint32_t i = 0;
        for (const Attribute& attribute : from_.attributes_of(e)) {
            const bool change = here && i++ == chosen;
            if (change && change_ == Change::drop_attribute) { continue; }
            std::string name(from_.string(attribute.name));
            std::string value(from_.string(attribute.value));
            if (change && change_ == Change::attribute_name) { name = one_of(names, random_); }
            if (change && change_ == Change::value) { value = one_of(values, random_); }
            if (to_.find(out, name) == nullptr) { to_.add_attribute(out, name, value, {}, {}); }
        }
        if (!here || change_ != Change::add_attribute) { return; }
        const std::string name = one_of(names, random_);
        if (to_.find(out, name) == nullptr) {
            to_.add_attribute(out, name, one_of(values, random_), {}, {});
        }
    }

    void set_text(ElementId e, std::string_view text) {
        const Piece piece = to_.add_string(text);
        to_.elements[e.index].text = piece;
    }

    const Document& from_;
    Random& random_;
    ElementId at_;
    Change change_;
    Document to_;
};

/// Every array and object of a value, outermost first.
void collect(Json& value, std::vector<Json*>& out) {
    if (!value.is_structured()) { return; }
    out.push_back(&value);
    for (Json& inner : value) {
        collect(inner, out);
    }
}

Json random_value(Random& random) {
    switch (random.below(7)) {
    case 0: return 5;
    case 1: return -1.5;
    case 2: return true;
    case 3: return nullptr;
    case 4: return Json::array();
    case 5: return Json::object();
    default: return one_of(values, random);
    }
}

void mutate_object(Json& object, const Json& other, Random& random) {
    const std::uint32_t size = static_cast<std::uint32_t>(object.size());
    const std::uint32_t chosen = size == 0 ? 0 : random.below(size);
    const std::uint32_t change = random.below(4);
    Json out = Json::object();
    std::uint32_t i = 0;
    for (const auto& [key, value] : object.items()) {
        const bool here = i++ == chosen;
        if (here && change == 0) { continue; }
        out[here && change == 1 ? std::string(one_of(names, random)) : key] =
            here && change == 2 ? random_value(random) : value;
    }
    if (change == 3) {
        out[one_of(names, random)] = random.one_in(2) ? random_value(random) : other;
    }
    object = std::move(out);
}

}  // namespace

std::string mutated_xml(std::string_view text, Random& random) {
    Diagnostics none;
    const auto document = read_xml(text, none.add_file("", text), none);
    return XmlMutation(*document, random).write();
}

std::string mutated_json(std::string_view text, Random& random) {
    Json root = Json::parse(text);
    std::vector<Json*> inner;
    collect(root, inner);
    const auto any = [&] { return inner[random.below(static_cast<std::uint32_t>(inner.size()))]; };
    const Json other = *any();
    Json& chosen = *any();
    if (chosen.is_object()) {
        mutate_object(chosen, other, random);
    } else if (chosen.empty() || random.one_in(3)) {
        chosen.push_back(other);
    } else {
        const std::size_t i = random.below(static_cast<std::uint32_t>(chosen.size()));
        if (random.one_in(2)) {
            chosen.erase(i);
        } else {
            chosen[i] = random_value(random);
        }
    }
    return root.dump(2) + "\n";
}

}  // namespace trellis::test
