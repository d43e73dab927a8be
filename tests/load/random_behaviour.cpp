// Random tree files and machines, in the order that JSON gives back. Written apart from the code
// under test, so that what that code moves or loses shows. Covered by the tests that use it.
// SPDX-License-Identifier: MIT
#include "load/random_document.h"

namespace trellis::test {

namespace {

/// Builds one document; the functions are named after what they add.
class Builder {
public:
    explicit Builder(Random& random) : random_(random) {}

    Document tree_file() {
        const ElementId root = begin({}, "root");
        some(3, [&] { close(begin(root, "include")); });
        some(2, [&] {
            document_.close(document_.open(root, "include", {}));
            document_.add_attribute(last(), "path", "x.xml", {}, {});
        });
        some(3, [&] { behaviour_tree(root); });
        if (random_.one_in(2)) { models(root); }
        some(3, [&] { anything(root); });
        close(root);
        return std::move(document_);
    }

    Document machine() {
        const ElementId root = document_.open({}, "scxml", {});
        document_.add_attribute(root, "xmlns", "http://www.w3.org/2005/07/scxml", {}, {});
        document_.add_attribute(root, "xmlns:x", "urn:x", {}, {});
        if (random_.one_in(2)) { document_.add_attribute(root, "xmlns:x2", "urn:x2", {}, {}); }
        add_random_attributes(document_, root, random_);
        decorate(root);
        state_content(root, 0);
        close(root);
        return std::move(document_);
    }

private:
    template <class Add>
    void some(std::uint32_t most, Add add) {
        for (std::uint32_t n = random_.below(most + 1); n > 0; --n) {
            add();
        }
    }

    ElementId last() const { return {static_cast<std::uint32_t>(document_.elements.size() - 1)}; }
    void close(ElementId e) { document_.close(e); }

    void decorate(ElementId e) {
        const std::string doc = random_.one_in(4) ? random_doc(random_) : "";
        const std::string text = random_.one_in(6) ? random_text(random_) : "";
        document_.elements[e.index].doc = document_.add_string(doc);
        document_.elements[e.index].text = document_.add_string(text);
    }

    /// An element with attributes and perhaps a doc and a text.
    ElementId begin(ElementId parent, std::string_view name) {
        const ElementId e = document_.open(parent, name, {});
        decorate(e);
        add_random_attributes(document_, e, random_);
        return e;
    }
    void leaf(ElementId parent, std::string_view name) { close(begin(parent, name)); }

    /// An element without attributes, doc and text: JSON writes it as an array.
    ElementId list(ElementId parent, std::string_view name) {
        return document_.open(parent, name, {});
    }

    void anything(ElementId parent) {
        const Document other = random_document(random_);
        copy_subtree(other, {random_.below(20)}, document_, parent);
    }

    // Trees ---------------------------------------------------------------------------------------

    void behaviour_tree(ElementId root) {
        const ElementId e = begin(root, "BehaviorTree");
        some(2, [&] { anything(e); });
        close(e);
    }

    void models(ElementId root) {
        const ElementId e = list(root, "TreeNodesModel");
        some(3, [&] {
            const ElementId model = begin(e, random_.one_in(2) ? "Action" : "SubTree");
            some(3, [&] { leaf(model, random_.one_in(2) ? "input_port" : "inout_port"); });
            if (random_.one_in(4)) { anything(model); }
            close(model);
        });
        close(e);
    }

    // Machines ------------------------------------------------------------------------------------

    void state_content(ElementId e, int depth) {
        if (random_.one_in(2)) {
            const ElementId data = list(e, "datamodel");
            some(3, [&] { body(data, "data"); });
            close(data);
        }
        some(1, [&] { body(e, "script"); });
        some(2, [&] { block(e, "onentry", depth); });
        some(2, [&] { block(e, "onexit", depth); });
        if (random_.one_in(4)) {
            const ElementId initial = list(e, "initial");
            with_actions(initial, "transition", depth);
            close(initial);
        }
        some(2, [&] { payload(e, "invoke", depth); });
        some(2, [&] { with_actions(e, "transition", depth); });
        if (random_.one_in(4)) { payload(e, "donedata", depth); }
        if (depth < 3) {
            some(2, [&] { state(e, depth + 1); });
        }
        some(1, [&] { foreign(e); });
    }

    void state(ElementId parent, int depth) {
        static constexpr std::string_view kinds[] = {"state", "parallel", "final", "history"};
        const ElementId e = begin(parent, kinds[random_.below(4)]);
        state_content(e, depth);
        close(e);
    }

    void foreign(ElementId parent) {
        const ElementId e = begin(parent, "x:custom");
        some(2, [&] { anything(e); });
        close(e);
    }

    void body(ElementId parent, std::string_view name) {
        const ElementId e = begin(parent, name);
        some(1, [&] { anything(e); });
        close(e);
    }

    void block(ElementId parent, std::string_view name, int depth) {
        const ElementId e = list(parent, name);
        some(3, [&] { action(e, depth + 1); });
        close(e);
    }

    void with_actions(ElementId parent, std::string_view name, int depth) {
        const ElementId e = begin(parent, name);
        if (depth < 4) {
            some(2, [&] { action(e, depth + 1); });
        }
        close(e);
    }

    void payload(ElementId parent, std::string_view name, int depth) {
        const ElementId e = begin(parent, name);
        some(2, [&] { body(e, "param"); });
        if (random_.one_in(2)) {
            const ElementId content = begin(e, "content");
            if (depth < 2 && random_.one_in(2)) {
                const ElementId machine = begin(content, "scxml");
                state_content(machine, depth + 2);
                close(machine);
            } else {
                some(2, [&] { anything(content); });
            }
            close(content);
        }
        if (name == "invoke" && random_.one_in(2)) { block(e, "finalize", depth); }
        if (random_.one_in(4)) { foreign(e); }
        close(e);
    }

    void action(ElementId parent, int depth) {
        static constexpr std::string_view simple[] = {"raise",   "log", "cancel", "script",
                                                      "foreach", "if",  "x:act",  "else"};
        switch (random_.below(5)) {
        case 0: payload(parent, "send", depth); break;
        case 1: body(parent, "assign"); break;
        case 2: branches(parent, depth); break;
        default: with_actions(parent, simple[random_.below(8)], depth);
        }
    }

    void branches(ElementId parent, int depth) {
        const ElementId e = begin(parent, "if");
        if (depth < 4) {
            some(2, [&] { action(e, depth + 1); });
            some(2, [&] {
                close(document_.open(e, "elseif", {}));
                document_.add_attribute(last(), "cond", random_string(random_), {}, {});
                add_random_attributes(document_, last(), random_);
                some(2, [&] { action(e, depth + 1); });
            });
            if (random_.one_in(2)) {
                leaf(e, "else");
                some(2, [&] { action(e, depth + 1); });
            }
        }
        close(e);
    }

    Random& random_;
    Document document_;
};

}  // namespace

Document random_tree_file(Random& random) {
    return Builder(random).tree_file();
}
Document random_machine(Random& random) {
    return Builder(random).machine();
}

}  // namespace trellis::test
