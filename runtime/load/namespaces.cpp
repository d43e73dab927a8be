// A stack of declarations, searched from its top. Covered by tests/load/check_test.cpp.
// SPDX-License-Identifier: MIT
#include "load/namespaces.h"

namespace trellis {

namespace {

/// The namespace of the attributes that tell an editor which schema a document has.
constexpr std::string_view schema_instance = "http://www.w3.org/2001/XMLSchema-instance";

/// What is before the colon; empty if there is none.
std::string_view prefix_of(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

}  // namespace

Namespaces::Mark Namespaces::enter(ElementId e) {
    const Mark mark = declared_.size();
    for (const Attribute& attribute : document_.attributes_of(e)) {
        const std::string_view name = document_.string(attribute.name);
        if (name == "xmlns" || name.starts_with("xmlns:")) {
            declared_.push_back(
                {name.substr(name == "xmlns" ? 5 : 6), document_.string(attribute.value)});
        }
    }
    return mark;
}

std::string_view Namespaces::local(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

const std::string_view* Namespaces::uri_of(std::string_view prefix) const {
    for (std::size_t i = declared_.size(); i-- > 0;) {
        if (declared_[i].prefix == prefix) { return &declared_[i].uri; }
    }
    return nullptr;
}

Namespaces::Space Namespaces::space_of_element(std::string_view name) const {
    if (own_.empty()) { return Space::own; }
    const std::string_view* uri = uri_of(prefix_of(name));
    if (uri == nullptr || uri->empty()) { return Space::none; }
    return *uri == own_ ? Space::own : Space::foreign;
}

bool Namespaces::is_passed_over(std::string_view name) const {
    if (name.starts_with("xmlns:")) { return true; }
    if (name == "xmlns" || name.starts_with("xml:")) { return !own_.empty(); }
    const std::string_view prefix = prefix_of(name);
    const std::string_view* uri = prefix.empty() ? nullptr : uri_of(prefix);
    if (uri == nullptr || uri->empty()) { return false; }
    if (!own_.empty()) { return *uri != own_; }
    return *uri == schema_instance &&
           (local(name) == "schemaLocation" || local(name) == "noNamespaceSchemaLocation");
}

}  // namespace trellis
