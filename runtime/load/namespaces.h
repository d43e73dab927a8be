// Which namespace the names of an XML document are in, while it is walked. JSON documents have
// none: there, every element is the dialect's own. Covered by tests/load/check_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace trellis {

/// The xmlns declarations in force at one element. Views point into the document, which must
/// outlive this.
class Namespaces {
public:
    /// Where a name belongs.
    enum class Space : std::uint8_t {
        own,      ///< the dialect
        foreign,  ///< another namespace: not looked at
        none,     ///< no namespace though the dialect has one, or a prefix that is not declared
    };

    /// `own`: the namespace of the dialect; empty if it has none, as trees.
    Namespaces(const Document& document, std::string_view own) : document_(document), own_(own) {}

    std::string_view own() const { return own_; }

    /// What leave() goes back to.
    using Mark = std::size_t;
    /// Takes in the declarations of an element that the walk comes to.
    Mark enter(ElementId e);
    /// Forgets what was declared since enter().
    void leave(Mark mark) { declared_.resize(mark); }
    /// From here on, names without a prefix are the dialect's own.
    void adopt_default() { declared_.push_back({{}, own_}); }

    /// Without the prefix.
    static std::string_view local(std::string_view name);
    Space space_of_element(std::string_view name) const;
    /// Whether an attribute is a declaration, names a schema for an editor, or belongs to another
    /// namespace that the dialect lets pass.
    bool is_passed_over(std::string_view name) const;

private:
    struct Declaration {
        std::string_view prefix, uri;
    };
    /// The namespace of a prefix; null if it is not declared.
    const std::string_view* uri_of(std::string_view prefix) const;

    const Document& document_;
    std::string_view own_;
    std::vector<Declaration> declared_;
};

}  // namespace trellis
