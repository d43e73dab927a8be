// XML with numbers, and records of nine bytes.
// SPDX-License-Identifier: MIT
#include "runner/groot_log.h"

#include "load/xml.h"
#include "runner/palette.h"
#include "runner/places.h"
#include "runner/profile_report.h"

#include <cmath>
#include <utility>
#include <vector>

namespace trellis {

namespace {

/// Writes the trees of a program into a document.
class TreeWriter {
public:
    TreeWriter(const Program& program, std::span<const Document> files)
        : program_(program), files_(files) {
        for (std::uint32_t i = 0; i < files.size(); ++i) {
            places_.emplace_back(program, files[i], i);
        }
    }

    Document write(const Registry& registry) {
        root_ = out_.open({}, "root", {});
        out_.add_attribute(root_, "BTCPP_format", "4", {}, {});
        add_tree({0}, program_.name({0}), "");
        // subtrees add themselves while the trees around them are written
        for (std::size_t i = 0; i < uses_.size(); ++i) {
            const Use use = uses_[i];
            add_tree(use.row, use.id, use.path);
        }
        add_models(out_, root_, registry);
        out_.close(root_);
        return std::move(out_);
    }

private:
    struct Use {
        RowId row;  ///< of the SubTree
        std::string id, path;
    };

    void add_tree(RowId n, std::string_view id, const std::string& path) {
        const ElementId tree = out_.open(root_, "BehaviorTree", {});
        out_.add_attribute(tree, "ID", id, {}, {});
        out_.add_attribute(tree, "_fullpath", path, {}, {});
        for (const RowId child : children(program_, n)) {
            add_node(tree, child, path);
        }
        out_.close(tree);
    }

    // Recursion is bounded: programs are at most 256 deep.
    void add_node(ElementId parent, RowId n, const std::string& path) {
        const bool subtree = program_.at(n).op == Op::subtree;
        const ElementId e = out_.open(parent, kind_of(program_, n), {});
        if (!subtree) { out_.add_attribute(e, "name", program_.name(n), {}, {}); }
        const std::string id = copy_attributes(n, e);
        std::string inside = path.empty() ? "" : path + '/';
        inside += program_.name(n) == id ? id + "::" + std::to_string(n.index)
                                         : std::string(program_.name(n));
        if (subtree) { out_.add_attribute(e, "_fullpath", inside, {}, {}); }
        out_.add_attribute(e, "_uid", std::to_string(n.index), {}, {});
        if (subtree) {
            uses_.push_back({n, id, std::move(inside)});
        } else {
            for (const RowId child : children(program_, n)) {
                add_node(e, child, path);
            }
        }
        out_.close(e);
    }

    /// Ports, conditions and, of a SubTree, the ID of its tree, which is returned.
    std::string copy_attributes(RowId n, ElementId to) {
        const std::uint32_t file = program_.origins[n.index].file;
        if (file >= files_.size()) { return {}; }
        const ElementId e = places_[file].of(n);
        if (!e) { return {}; }
        const Document& from = files_[file];
        const bool subtree = from.name(e) == "SubTree";
        for (const Attribute& attribute : from.attributes_of(e)) {
            const std::string_view name = from.string(attribute.name);
            // the long form's ID is the name of the element now
            if (name == "name" || name == "_uid" || name == "_fullpath") { continue; }
            if (name == "ID" && !subtree) { continue; }
            out_.add_attribute(to, name, from.string(attribute.value), {}, {});
        }
        return std::string(from.value(e, "ID"));
    }

    const Program& program_;
    std::span<const Document> files_;
    std::vector<Places> places_;  // by file
    Document out_;
    ElementId root_;
    std::vector<Use> uses_;
};

void append_bytes(std::string& out, std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) {
        out += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
}

}  // namespace

std::string groot_xml(const Program& program, std::span<const Document> files,
                      const Registry& registry) {
    return write_xml(TreeWriter(program, files).write(registry));
}

std::string groot_log(const Recording& recording, std::string_view xml, std::int64_t start) {
    std::string out = "BTCPP4-FileLogger2";
    append_bytes(out, 1, 1);  // protocol
    append_bytes(out, xml.size(), 4);
    out += xml;
    append_bytes(out, static_cast<std::uint64_t>(start), 8);
    for (const TraceEvent& event : recording.events) {
        // row 0 is the <BehaviorTree>, which is no node
        if (event.kind != TraceEvent::Kind::status || event.row.index == 0) { continue; }
        const double usec = static_cast<double>(event.tick) * recording.dt * 1e6;
        append_bytes(out, static_cast<std::uint64_t>(std::llround(usec)), 6);
        append_bytes(out, event.row.index, 2);
        append_bytes(out, static_cast<std::uint64_t>(event.to), 1);
    }
    return out;
}

}  // namespace trellis
