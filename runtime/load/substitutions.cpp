// Reading the rules of substitutions.h.
// SPDX-License-Identifier: MIT
#include "load/substitutions.h"

#include "load/json_tree.h"
#include "load/text.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace trellis {

namespace {

using Kind = JsonValue::Kind;

class RuleReader {
public:
    RuleReader(const JsonTree& json, const Grammar& grammar, Diagnostics& diagnostics)
        : json_(json), grammar_(grammar), diagnostics_(diagnostics) {}

    Substitutions read() {
        if (!expect(json_.root(), Kind::object, "an object")) { return {}; }
        for (const JsonId part : json_.children(json_.root())) {
            const bool tests = json_.key(part) == "TestNodeConfigs";
            if (!tests && json_.key(part) != "SubstitutionRules") {
                unknown_member(part, {"TestNodeConfigs", "SubstitutionRules"});
            } else if (tests && expect(part, Kind::object, "an object")) {
                for (const JsonId test : json_.children(part)) {
                    read_test(test);
                }
            }
        }
        // a rule may stand before the test that it names
        const JsonId rules = json_.member(json_.root(), "SubstitutionRules");
        if (rules && expect(rules, Kind::object, "an object")) {
            for (const JsonId rule : json_.children(rules)) {
                read_rule(rule);
            }
        }
        return std::move(out_);
    }

private:
    bool expect(JsonId value, Kind kind, std::string_view what) {
        if (json_.kind(value) == kind) { return true; }
        diagnostics_.error(
            "json-type", json_.at(value).where,
            "expected " + std::string(what) +
                (json_.key(value).empty() ? "" : " for \"" + std::string(json_.key(value)) + '"'));
        return false;
    }
    void unknown_member(JsonId value, const std::vector<std::string_view>& known) {
        diagnostics_.error("json-member", json_.at(value).key_where,
                           "unknown member \"" + std::string(json_.key(value)) + '"' +
                               suggestion(json_.key(value), known));
    }

    void read_test(JsonId value) {
        if (!expect(value, Kind::object, "an object")) { return; }
        TestConfig& test = out_.tests.emplace_back();
        test.name = json_.key(value);
        const std::pair<std::string_view, RuleScript TestConfig::*> scripts[] = {
            {"return_status_script", &TestConfig::status_script},
            {"success_script", &TestConfig::success_script},
            {"failure_script", &TestConfig::failure_script},
            {"post_script", &TestConfig::post_script},
        };
        for (const JsonId member : json_.children(value)) {
            const std::string_view key = json_.key(member);
            const auto* const script =
                std::find_if(std::begin(scripts), std::end(scripts),
                             [&](const auto& known) { return known.first == key; });
            if (script != std::end(scripts)) {
                if (!expect(member, Kind::string, "a script")) { continue; }
                test.*script->second = {std::string(json_.text(member)), json_.at(member).where};
            } else if (key == "return_status") {
                read_status(member, test);
            } else if (key == "async_delay") {
                read_delay(member, test);
            } else {
                unknown_member(member, {"return_status", "return_status_script", "success_script",
                                        "failure_script", "post_script", "async_delay"});
            }
        }
    }

    void read_status(JsonId value, TestConfig& test) {
        if (!expect(value, Kind::string, "a status")) { return; }
        constexpr Status all[] = {Status::success, Status::failure, Status::running,
                                  Status::skipped};
        const Status* const found =
            std::find_if(std::begin(all), std::end(all),
                         [&](Status status) { return name_of(status) == json_.text(value); });
        if (found != std::end(all)) {
            test.status = *found;
            return;
        }
        diagnostics_.error("bad-value", json_.at(value).where,
                           "\"return_status\": expected SUCCESS, FAILURE, RUNNING or SKIPPED, "
                           "found " +
                               quoted(json_.text(value)));
    }

    void read_delay(JsonId value, TestConfig& test) {
        const std::string_view text = json_.text(value);
        std::uint32_t ms = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ms);
        if (json_.kind(value) == Kind::number && error == std::errc() &&
            end == text.data() + text.size()) {
            test.delay = ms;
            return;
        }
        diagnostics_.error("bad-value", json_.at(value).where,
                           "\"async_delay\": expected whole milliseconds, found " + quoted(text));
    }

    void read_rule(JsonId value) {
        if (!expect(value, Kind::string, "the name of a test or node")) { return; }
        SubstitutionRule rule{.pattern = std::string(json_.key(value)),
                              .node = std::string(json_.text(value)),
                              .where = json_.at(value).where};
        std::vector<std::string_view> known;
        for (std::uint32_t i = 0; i < out_.tests.size(); ++i) {
            if (out_.tests[i].name == rule.node) { rule.test = i; }
            known.push_back(out_.tests[i].name);
        }
        bool is_node = false;
        for (const RuleId id : grammar_.at(grammar_.nodes).rules) {
            const ElementRule& node = grammar_.at(id);
            if (node.open != ElementRule::Open::closed) { continue; }
            is_node = is_node || node.name == rule.node;
            known.push_back(node.name);
        }
        if (rule.test == SubstitutionRule::no_test && !is_node) {
            diagnostics_.error("unknown-node", rule.where,
                               "there is neither a test nor a node " + quoted(rule.node) +
                                   suggestion(rule.node, known));
            return;
        }
        out_.rules.push_back(std::move(rule));
    }

    const JsonTree& json_;
    const Grammar& grammar_;
    Diagnostics& diagnostics_;
    Substitutions out_;
};

}  // namespace

Substitutions read_substitutions(const Source& source, const Grammar& grammar,
                                 Diagnostics& diagnostics, const LoadOptions& options) {
    const std::uint32_t file = diagnostics.add_file(source.name, source.text);
    const std::optional<JsonTree> json = parse_json(source.text, file, diagnostics, options.limits);
    return json ? RuleReader(*json, grammar, diagnostics).read() : Substitutions();
}

// The place after the last * is tried again one character further each time the rest fails.
bool matches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0;
    std::size_t t = 0;
    std::size_t star = std::string_view::npos;
    std::size_t retry = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            retry = t;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++retry;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace trellis
