// Ports without members, and where they are declared.
// SPDX-License-Identifier: MIT
#include "runner/declarations.h"

#include "load/grammar.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

namespace trellis {

namespace {

/// Space for one declared port: a value of any type, and whether it is there.
struct PortSpace {
    alignas(16) std::byte value[24];
    bool present;
};

PortType port_type(std::string_view name) {
    for (const PortType type :
         {PortType::boolean, PortType::int32, PortType::int64, PortType::real, PortType::text}) {
        if (name == name_of(type)) { return type; }
    }
    return PortType::any;
}

PortDirection port_direction(std::string_view element) {
    return element == "output_port"  ? PortDirection::output
           : element == "inout_port" ? PortDirection::inout
                                     : PortDirection::input;
}

/// How many children a node may have that is declared by such an element; none for a subtree.
std::optional<std::uint32_t> most_children(std::string_view element) {
    if (element == "Action" || element == "Condition") { return 0; }
    if (element == "Decorator") { return 1; }
    if (element == "Control") { return ElementRule::many; }
    return {};
}

LeafType declared_node(const Document& document, ElementId model) {
    LeafType leaf;
    leaf.name = document.value(model, "ID");
    leaf.doc = document.doc(model);
    leaf.condition = document.name(model) == "Condition";
    leaf.synchronous = leaf.condition;
    leaf.most_children = *most_children(document.name(model));
    leaf.align = alignof(PortSpace);
    // all bytes of a struct are zero before it is constructed: no values, no texts
    leaf.construct = [](std::byte*) {};
    for (const ElementId e : document.children(model)) {
        if (!document.name(e).ends_with("_port")) { continue; }
        Port& port = leaf.ports.emplace_back();
        port.name = document.value(e, "name");
        port.doc = document.text(e);
        port.type = port_type(document.value(e, "type"));
        port.direction = port_direction(document.name(e));
        port.offset = leaf.size;
        port.present = leaf.size + static_cast<std::uint32_t>(offsetof(PortSpace, present));
        leaf.size += static_cast<std::uint32_t>(sizeof(PortSpace));
    }
    return leaf;
}

/// Whether a leaf has all ports of a declaration: else that is of another robot's leaf, whose name
/// happens to be the same, as the Wait of Nav2.
bool has_ports_of(const LeafType& leaf, const LeafType& declared) {
    return std::all_of(declared.ports.begin(), declared.ports.end(),
                       [&](const Port& port) { return leaf.find(port.name) != nullptr; });
}

bool has_child(const Document& document, std::string_view name) {
    for (const ElementId e : document.children(document.root())) {
        if (document.name(e) == name) { return true; }
    }
    return false;
}

/// The palette in a file of --nodes; false after messages.
bool declare_file(const std::string& file, Registry& registry, Streams& streams, Exit& exit) {
    const std::optional<Document> document = load_document(file, streams, exit);
    if (!document) { return false; }
    if (!has_child(*document, "TreeNodesModel")) {
        exit = complain(streams, Exit::no, shown_name(file) + " has no TreeNodesModel");
        return false;
    }
    declare_nodes(*document, registry);
    return true;
}

/// The nodes of a document, and of the files it includes. What is wrong with these is for compiling
/// to say, which reads them again.
void declare_all(const Document& document, const std::string& name, const LoadArguments& arguments,
                 Registry& registry, Streams& streams) {
    FileReader reader(arguments, streams.files);
    std::set<std::string> known = {name};
    std::size_t left = DocumentLimits().bytes;
    const auto declare = [&](const Document& in, const std::string& from, auto&& self) -> void {
        declare_nodes(in, registry);
        for (const ElementId e : in.children(in.root())) {
            if (in.name(e) != "include" || known.size() > LoadOptions().includes) { continue; }
            std::optional<Source> source =
                reader.read(in.value(e, "path"), from, in.value(e, "ros_pkg"));
            if (!source || source->text.size() > left) { continue; }
            left -= source->text.size();
            const std::string included = source->name;
            if (!known.insert(included).second) { continue; }
            Diagnostics unsaid;
            const std::optional<Document> read_in = read(std::move(*source), unsaid);
            if (read_in && !read_in->empty()) { self(*read_in, included, self); }
        }
    };
    declare(document, name, declare);
}

/// Makes every use of a node that cannot be ticked an error.
void refuse_declared(const Program& program, Declared allowed, Diagnostics& diagnostics) {
    for (RowId n{0}; n.index < program.rows.size(); ++n.index) {
        const Op op = program.at(n).op;
        if (op != Op::action && op != Op::condition) { continue; }
        const LeafType& type = *program.call(n).type;
        const bool fits = allowed == Declared::leaves && type.most_children == 0;
        if (!is_declared(type) || fits) { continue; }
        const Origin& place = program.origins[n.index];
        diagnostics.error("only-declared", {place.file, place.line, place.column},
                          type.name +
                              " is only declared: it does not run here; a rule of --mock can put "
                              "another node in its place");
    }
    for (const Program& machine : program.machines) {
        refuse_declared(machine, allowed, diagnostics);
    }
}

/// The behaviour, once its findings were told; none if it has no program.
std::optional<Behaviour> told(Behaviour behaviour, Streams& streams, Exit& exit) {
    show(behaviour.diagnostics, streams);
    exit = behaviour.program ? Exit::yes : Exit::no;
    if (!behaviour.program) { return {}; }
    return behaviour;
}

}  // namespace

void declare_nodes(const Document& document, Registry& registry) {
    for (const ElementId models : document.children(document.root())) {
        if (document.name(models) != "TreeNodesModel") { continue; }
        for (const ElementId model : document.children(models)) {
            const std::string_view id = document.value(model, "ID");
            const OpTable ops = op_table();
            const bool built_in = std::any_of(ops.begin(), ops.end(),
                                              [&](const OpInfo& op) { return op.element == id; });
            if (!most_children(document.name(model)) || built_in || id.empty()) { continue; }
            LeafType declared = declared_node(document, model);
            const LeafType* const known = registry.find(id);
            const bool is_new =
                known == nullptr || (!is_declared(*known) && !has_ports_of(*known, declared));
            if (is_new) { registry.add(std::move(declared)); }
        }
    }
}

bool is_palette(const Document& document) {
    return file_kind(document) == FileKind::tree && has_child(document, "TreeNodesModel") &&
           !has_child(document, "BehaviorTree") && !has_child(document, "include");
}

std::optional<Behaviour> read_declaring(const std::string& file, const LoadArguments& arguments,
                                        Registry& registry, Streams& streams, Exit& exit) {
    for (const std::string& nodes : arguments.nodes) {
        if (!declare_file(nodes, registry, streams, exit)) { return {}; }
    }
    exit = Exit::file;
    std::optional<std::string> text = read_text(file, streams, DocumentLimits().bytes);
    if (!text) { return {}; }
    exit = Exit::yes;
    Source source{shown_name(file), {}};
    {
        Diagnostics said;  // compiling says it all again, of what could be read
        const std::optional<Document> document = read({source.name, std::move(*text)}, said);
        if (!document) {
            said.sort();
            return Behaviour{std::move(source.name), {}, std::move(said)};
        }
        declare_all(*document, source.name, arguments, registry, streams);
        source.text = said.file_text(0);
    }
    std::optional<Behaviour> behaviour =
        compile_behaviour(std::move(source), arguments, registry, streams);
    if (!behaviour) { exit = Exit::file; }
    return behaviour;
}

std::optional<Behaviour> load_declaring(const std::string& file, const LoadArguments& arguments,
                                        Registry& registry, Streams& streams, Exit& exit) {
    std::optional<Behaviour> behaviour = read_declaring(file, arguments, registry, streams, exit);
    return behaviour ? told(std::move(*behaviour), streams, exit) : std::nullopt;
}

std::optional<Behaviour> load_behaviour(const std::string& file, const LoadArguments& arguments,
                                        Registry& registry, Streams& streams, Exit& exit,
                                        Declared allowed) {
    std::optional<Behaviour> behaviour = read_declaring(file, arguments, registry, streams, exit);
    if (!behaviour) { return {}; }
    if (behaviour->program) {
        refuse_declared(*behaviour->program, allowed, behaviour->diagnostics);
        behaviour->diagnostics.sort();
        if (!behaviour->diagnostics.ok()) { behaviour->program.reset(); }
    }
    return told(std::move(*behaviour), streams, exit);
}

}  // namespace trellis
