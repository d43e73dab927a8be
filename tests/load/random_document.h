// Random documents for property tests: names and strings with every character that is hard to write
// in XML or JSON. Used by xml_test.cpp and the JSON tests.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <cstdint>
#include <random>
#include <string>

namespace trellis::test {

/// std::mt19937 with the few draws that the tests need; equal on every platform.
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_()) % n; }
    bool one_in(std::uint32_t n) { return below(n) == 0; }

private:
    std::mt19937 engine_;
};

/// A few characters: quotes, markup, line ends, blanks, hyphens, backslashes, UTF-8 of all lengths.
std::string random_string(Random& random);
/// Text as documents keep it: not only blanks, or empty.
std::string random_text(Random& random);
/// A doc as documents keep it: no blanks around it, no carriage return.
std::string random_doc(Random& random);
std::string random_name(Random& random);

/// Some attributes of different names for the element that was opened last.
void add_random_attributes(Document& document, ElementId e, Random& random);
/// A tree of about 20 elements with attributes, docs and texts.
Document random_document(Random& random);
/// A tree file, or a machine, in its canonical form (json.h): every kind of child in its place,
/// with random attributes, docs, texts and elements that the dialect does not know.
Document random_tree_file(Random& random);
Document random_machine(Random& random);
/// The text with a few bytes changed, removed, repeated or moved: mostly no document any more.
std::string mutated(std::string text, Random& random);

}  // namespace trellis::test
