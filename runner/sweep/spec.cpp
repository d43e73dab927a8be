// From JSON values to a SweepSpec, and what is wrong with it beyond names and types.
// SPDX-License-Identifier: MIT
#include "runner/sweep/spec.h"

#include "core/number.h"
#include "load/text.h"
#include "runner/table.h"

#include <algorithm>
#include <utility>

namespace trellis {
namespace {

using Kind = FileMember::Kind;
using Limit = FileMember::Limit;
using Need = FileMember::Need;

enum : std::uint8_t {
    none,
#define OBJECT(name, article) name,
#define MEMBER(object, name, kind, of, need, limit, doc)
#include "runner/sweep/sweep_grammar.def"
};

constexpr FileObject objects[] = {
    {"", ""},
#define OBJECT(name, article) {#name, article},
#define MEMBER(object, name, kind, of, need, limit, doc)
#include "runner/sweep/sweep_grammar.def"
};

constexpr FileMember members[] = {
#define OBJECT(name, article)
#define MEMBER(object, name, kind, of, need, limit, doc)                                           \
    {object, #name, Kind::kind, of, Need::need, Limit::limit, doc},
#include "runner/sweep/sweep_grammar.def"
};

constexpr FileGrammar grammar{"Trellis sweep file", objects, members};

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Takes values out of a file that check_file() has accepted.
class Reader {
public:
    Reader(const JsonTree& json, Diagnostics& diagnostics)
        : json_(json), diagnostics_(diagnostics) {}

    SweepSpec spec() {
        const JsonId root = json_.root();
        spec_.name = text_in(json_, root, "name");
        for (const JsonId value : list_in(json_, root, "behaviours"))
            behaviour(value);
        for (const JsonId value : list_in(json_, root, "worlds"))
            spec_.worlds.push_back(placed(value));
        if (spec_.worlds.empty()) spec_.worlds.push_back({"lab"});
        for (const JsonId value : list_in(json_, root, "parameters"))
            parameter(value);
        if (const JsonId seeds = json_.member(root, "seeds")) {
            spec_.first_seed = static_cast<std::int64_t>(number_in(json_, seeds, "first", 0.0));
            spec_.seeds = static_cast<std::uint64_t>(number_in(json_, seeds, "count", 1.0));
        }
        spec_.times = seconds("times");
        spec_.marks = seconds("marks");
        spec_.cell = number_in(json_, root, "cell", default_cell);
        spec_.fast = text_in(json_, root, "fast") == "true";
        spec_.dt = number_in(json_, root, "dt", lab_dt);
        check_size();
        return std::move(spec_);
    }

private:
    SpecText placed(JsonId value) const {
        return {std::string(json_.text(value)), json_.at(value).where};
    }

    void behaviour(JsonId value) {
        SpecBehaviour read{.name = text_in(json_, value, "name"),
                           .file = placed(json_.member(value, "file")),
                           .tree = text_in(json_, value, "tree")};
        if (read.name.empty()) read.name = read.file.text;
        for (const JsonId setting : list_in(json_, value, "set"))
            read.set.push_back({{std::string(json_.key(setting)), json_.at(setting).key_where},
                                std::string(json_.text(setting))});
        for (const SpecBehaviour& other : spec_.behaviours) {
            if (other.name == read.name)
                diagnostics_.error("sweep-name", json_.at(value).where,
                                   "there is another behaviour " + trellis::quoted(read.name) +
                                       "; give one of them another \"name\"");
        }
        spec_.behaviours.push_back(std::move(read));
    }

    void parameter(JsonId value) {
        SpecParameter read{.name = placed(json_.member(value, "name")), .values = {}, .of = {}};
        for (const JsonId one : list_in(json_, value, "values"))
            read.values.emplace_back(json_.text(one));
        for (const JsonId one : list_in(json_, value, "of")) {
            read.of.emplace_back(json_.text(one));
            check_name(placed(one));
        }
        check_once(read);
        spec_.parameters.push_back(std::move(read));
    }

    void check_name(const SpecText& name) {
        std::vector<std::string_view> known;
        for (const SpecBehaviour& behaviour : spec_.behaviours) {
            if (behaviour.name == name.text) return;
            known.emplace_back(behaviour.name);
        }
        diagnostics_.error("sweep-name", name.where,
                           "there is no behaviour " + trellis::quoted(name.text) +
                               suggestion(name.text, known));
    }

    // a value that another one replaces is a mistake, not a run
    void check_once(const SpecParameter& read) {
        for (const SpecBehaviour& behaviour : spec_.behaviours) {
            const bool is_set = std::any_of(
                behaviour.set.begin(), behaviour.set.end(),
                [&](const SpecBehaviour::Setting& s) { return s.name.text == read.name.text; });
            const bool is_tried = std::any_of(
                spec_.parameters.begin(), spec_.parameters.end(), [&](const SpecParameter& p) {
                    return p.name.text == read.name.text && p.is_of(behaviour);
                });
            if (read.is_of(behaviour) && (is_set || is_tried)) {
                diagnostics_.error("sweep-name", read.name.where,
                                   "the variable " + trellis::quoted(read.name.text) + " of " +
                                       quoted(behaviour.name) + " gets values from two places");
                return;
            }
        }
    }

    std::vector<double> seconds(std::string_view key) const {
        std::vector<double> values;
        for (const JsonId value : list_in(json_, json_.root(), key))
            values.push_back(parse_whole_number(json_.text(value)).value);
        std::sort(values.begin(), values.end());
        values.erase(std::unique(values.begin(), values.end()), values.end());
        return values;
    }

    void check_size() {
        double runs = 0.0;
        for (const SpecBehaviour& behaviour : spec_.behaviours) {
            double combinations = 1.0;
            for (const SpecParameter& parameter : spec_.parameters) {
                if (parameter.is_of(behaviour))
                    combinations *= static_cast<double>(parameter.values.size());
            }
            runs += combinations;
        }
        runs *= static_cast<double>(spec_.worlds.size()) * static_cast<double>(spec_.seeds);
        if (runs > static_cast<double>(most_runs))
            diagnostics_.error("sweep-size", json_.at(json_.root()).where,
                               "a sweep has at most " + std::to_string(most_runs) +
                                   " runs, these are " + brief(runs));
    }

    const JsonTree& json_;
    Diagnostics& diagnostics_;
    SweepSpec spec_;
};

}  // namespace

const FileGrammar& sweep_grammar() {
    return grammar;
}

bool SpecParameter::is_of(const SpecBehaviour& behaviour) const {
    return of.empty() || contains(of, behaviour.name);
}

std::optional<SweepSpec> read_sweep(std::string_view text, std::uint32_t file,
                                    Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.errors();
    const std::optional<JsonTree> json = parse_json(text, file, diagnostics);
    if (!json) return {};
    check_file(*json, grammar, diagnostics);
    if (diagnostics.errors() != before) return {};
    SweepSpec spec = Reader(*json, diagnostics).spec();
    if (diagnostics.errors() != before) return {};
    return spec;
}

}  // namespace trellis
