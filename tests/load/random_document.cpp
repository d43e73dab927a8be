// Random documents and mutated texts. Covered by the tests that use them.
// SPDX-License-Identifier: MIT
#include "load/random_document.h"

#include "load/text.h"

namespace trellis::test {

std::string random_string(Random& random) {
    static constexpr std::string_view parts[] = {
        "a",    "b1", " ",  "  ",   "\"",   "'",       "&",        "<",     ">",  "]]>", "\n",
        "\r\n", "\r", "\t", "--",   "-\\-", "\\",      "-",        "&amp;", "é",  "€",   "😀",
        "{x}",  "/",  "=",  "&#1;", "null", "<!-- x ", "\xC2\x80", "\x7F",  "0.5"};
    std::string out;
    for (std::uint32_t n = random.below(6); n > 0; --n) {
        out += parts[random.below(static_cast<std::uint32_t>(std::size(parts)))];
    }
    return out;
}

std::string random_text(Random& random) {
    const std::string text = random_string(random);
    return is_blank(text) ? std::string() : text;
}

std::string random_doc(Random& random) {
    return normal_doc(random_string(random));
}

std::string random_name(Random& random) {
    static constexpr std::string_view names[] = {
        "a", "Sequence", "type", "children", "doc", "ports",  "x:y",  "_skipIf",
        "é", "root",     "ID",   "text",     "do",  "states", "a-b.c"};
    return std::string(names[random.below(static_cast<std::uint32_t>(std::size(names)))]);
}

void add_random_attributes(Document& document, ElementId e, Random& random) {
    static constexpr std::string_view numbers[] = {"1",  "-3", "0.5",  "3.0",  "1e21",  "007",
                                                   "-0", "1.", "1.50", "true", "false", "null"};
    for (std::uint32_t n = random.below(5); n > 0; --n) {
        const std::string name = random_name(random);
        if (document.find(e, name) != nullptr) { continue; }
        const std::string value =
            random.one_in(3)
                ? std::string(numbers[random.below(static_cast<std::uint32_t>(std::size(numbers)))])
                : random_string(random);
        document.add_attribute(e, name, value, {}, {});
    }
}

Document random_document(Random& random) {
    Document document;
    std::vector<ElementId> open;
    for (int i = 0; i < 20; ++i) {
        while (open.size() > 1 && random.one_in(2)) {
            document.close(open.back());
            open.pop_back();
        }
        const ElementId parent = open.empty() ? ElementId{} : open.back();
        const ElementId e = document.open(parent, random_name(random), {});
        document.elements[e.index].doc =
            document.add_string(random.one_in(3) ? random_doc(random) : "");
        document.elements[e.index].text =
            document.add_string(random.one_in(3) ? random_text(random) : "");
        add_random_attributes(document, e, random);
        open.push_back(e);
    }
    for (; !open.empty(); open.pop_back()) {
        document.close(open.back());
    }
    return document;
}

std::string mutated(std::string text, Random& random) {
    static constexpr std::string_view bytes = "<>&;\"'/= !?-[]{}:,\\a0\n\0\x01\xC3\xFF";
    for (std::uint32_t n = 1 + random.below(4); n > 0 && !text.empty(); --n) {
        const std::uint32_t at = random.below(static_cast<std::uint32_t>(text.size()));
        const std::uint32_t size = random.below(20);
        switch (random.below(4)) {
        case 0: text[at] = bytes[random.below(static_cast<std::uint32_t>(bytes.size()))]; break;
        case 1: text.erase(at, size); break;
        case 2: text.insert(at, text.substr(at, size)); break;
        default: text.resize(at); break;
        }
    }
    return text;
}

}  // namespace trellis::test
