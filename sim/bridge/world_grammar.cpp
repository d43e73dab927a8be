// The table as data.
// SPDX-License-Identifier: MIT
#include "sim/bridge/world_grammar.h"

namespace trellis {
namespace {

using Kind = FileMember::Kind;
using Limit = FileMember::Limit;
using Need = FileMember::Need;

enum : std::uint8_t {
    none,
#define OBJECT(name, article) name,
#define MEMBER(object, name, kind, of, need, limit, doc)
#include "sim/bridge/world_grammar.def"
};

constexpr FileObject objects[] = {
    {"", ""},
#define OBJECT(name, article) {#name, article},
#define MEMBER(object, name, kind, of, need, limit, doc)
#include "sim/bridge/world_grammar.def"
};

constexpr FileMember members[] = {
#define OBJECT(name, article)
#define MEMBER(object, name, kind, of, need, limit, doc)                                           \
    {object, #name, Kind::kind, of, Need::need, Limit::limit, doc},
#include "sim/bridge/world_grammar.def"
};

constexpr FileGrammar grammar{"Trellis world file", objects, members};

}  // namespace

const FileGrammar& world_grammar() {
    return grammar;
}

}  // namespace trellis
