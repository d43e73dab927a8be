// Writing random statecharts.
// SPDX-License-Identifier: MIT
#include "support/random_machine.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace trellis::test {

namespace {

constexpr std::array names = {"a", "b", "c", "a.x", "a.x.y", "b.y", "ab"};
constexpr std::array descriptors = {"a",           "b",
                                    "c",           "a.x",
                                    "a.*",         "b.",
                                    "*",           "a.x.y c",
                                    "error",       "error.execution",
                                    "done.state",  ".*",
                                    "done.invoke", "error.communication"};
constexpr std::array conditions = {"true", "false", "_x.bumper", "n &lt; 5", "n > 2", "nosuch"};
constexpr std::array arrays = {"[1, 2]", "[]", "[1, 2, 3]", "n"};

template <class List>
std::string any_of(const List& list, Random& random) {
    return std::string(list[static_cast<std::size_t>(
        random.whole(0, static_cast<std::int64_t>(list.size()) - 1))]);
}

bool one_in(Random& random, int n) {
    return random.whole(1, n) == 1;
}

class Writer {
public:
    /// `inside`: of how many other machines.
    Writer(Random& random, int states, int inside) : random_(random), inside_(inside) {
        states_.emplace_back();
        make(0, states, 0);
    }

    std::string text() {
        std::string out = "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" version=\"1.0\" "
                          "datamodel=\"script\"";
        if (one_in(random_, 3)) { out += " initial=\"" + name(descendant(0)) + '"'; }
        out += "><datamodel><data id=\"n\" expr=\"0\"/></datamodel>";
        for (const std::size_t child : states_[0].children) {
            out += state(child);
        }
        return out + "</scxml>";
    }

private:
    enum class Kind { state, parallel, final };
    struct State {
        std::size_t parent = 0;
        Kind kind = Kind::state;
        std::vector<std::size_t> children;
        std::vector<std::string> histories;  ///< elements
        std::string invoke;                  ///< element
    };

    void make(std::size_t parent, int count, int depth) {
        while (count > 0) {
            const std::size_t s = states_.size();
            states_.push_back({.parent = parent, .children = {}, .histories = {}, .invoke = {}});
            states_[parent].children.push_back(s);
            --count;
            if (depth < 5 && count > 0 && one_in(random_, 2)) {
                const int inside = static_cast<int>(random_.whole(1, count));
                count -= inside;
                make(s, inside, depth + 1);
                const bool regions = states_[s].children.size() > 1 && !has_final(s);
                if (regions && !one_in(random_, 3)) { states_[s].kind = Kind::parallel; }
            } else if (states_[parent].children.size() > 1 && one_in(random_, 4)) {
                // a machine that ends at once says little
                states_[s].kind = Kind::final;
            }
            if (states_[s].kind != Kind::final && inside_ < 2 && one_in(random_, 25)) {
                invokes_.push_back("i" + std::to_string(s));
                states_[s].invoke = invoke(invokes_.back());
            }
        }
        if (parent != 0 && one_in(random_, 4)) { add_history(parent); }
    }

    bool has_final(std::size_t s) const {
        for (const std::size_t child : states_[s].children) {
            if (states_[child].kind == Kind::final) { return true; }
        }
        return false;
    }

    void add_history(std::size_t s) {
        const bool deep = one_in(random_, 2);
        const std::string id = 'h' + std::to_string(s);
        const std::size_t target = deep ? descendant(s) : any_of_states(states_[s].children);
        histories_.push_back(id);
        states_[s].histories.push_back("<history id=\"" + id + "\" type=\"" +
                                       (deep ? "deep" : "shallow") + "\"><transition target=\"" +
                                       name(target) + "\">" + log() + "</transition></history>");
    }

    std::string invoke(const std::string& id) {
        std::string out = "<invoke id=\"" + id + '"';
        if (one_in(random_, 3)) { out += " autoforward=\"true\""; }
        out += "><content>" +
               Writer(random_, static_cast<int>(random_.whole(1, 6)), inside_ + 1).text() +
               "</content>";
        if (one_in(random_, 3)) { out += "<finalize>" + log() + "</finalize>"; }
        return out + "</invoke>";
    }

    static std::string name(std::size_t s) { return 's' + std::to_string(s); }

    std::size_t any_of_states(const std::vector<std::size_t>& list) {
        return list[static_cast<std::size_t>(
            random_.whole(0, static_cast<std::int64_t>(list.size()) - 1))];
    }

    std::size_t descendant(std::size_t of) {
        std::size_t s = of;
        do {
            s = any_of_states(states_[s].children);
        } while (!states_[s].children.empty() && one_in(random_, 2));
        return s;
    }

    std::size_t any_state() {
        return static_cast<std::size_t>(
            random_.whole(1, static_cast<std::int64_t>(states_.size()) - 1));
    }

    /// A state, a history, or one state in each of two regions.
    std::string targets() {
        if (!histories_.empty() && one_in(random_, 5)) { return any_of(histories_, random_); }
        const std::size_t s = any_state();
        if (states_[s].kind != Kind::parallel || one_in(random_, 3)) { return name(s); }
        const std::size_t a = states_[s].children.front();
        const std::size_t b = states_[s].children.back();
        const auto inside = [this](std::size_t region) {
            return states_[region].children.empty() ? name(region) : name(descendant(region));
        };
        return inside(b) + ' ' + inside(a);
    }

    std::string condition() {
        if (one_in(random_, 3)) {
            return (one_in(random_, 2) ? "!In('" : "In('") + name(any_state()) + "')";
        }
        return any_of(conditions, random_);
    }

    std::string log() { return "<log label=\"" + std::to_string(++logs_) + "\"/>"; }

    std::string send() {
        std::string out = "<send event=\"" + any_of(names, random_) + '"';
        if (one_in(random_, 4)) {
            constexpr std::array targets = {"#_internal", "#_parent",   "baz",
                                            "#_scxml_s1", "#_scxml_s2", "#_i1"};
            out += " target=\"" +
                   (!invokes_.empty() && one_in(random_, 2) ? "#_" + any_of(invokes_, random_)
                                                            : any_of(targets, random_)) +
                   '"';
        } else if (inside_ > 0 && one_in(random_, 2)) {
            out += " target=\"#_parent\"";
        }
        if (!one_in(random_, 3)) {
            out += " delay=\"" + std::to_string(random_.whole(1, 3)) + "s\"";
        }
        if (one_in(random_, 2)) { out += one_in(random_, 2) ? " id=\"x\"" : " id=\"y\""; }
        return out + "/>";
    }

    std::string action(int depth) {
        switch (random_.whole(0, 9)) {
        case 0: return "<raise event=\"" + any_of(names, random_) + "\"/>";
        case 1: return "<assign location=\"n\" expr=\"n + 1\"/>";
        case 2: return one_in(random_, 3) ? "<assign location=\"n\" expr=\"nosuch\"/>" : log();
        case 3: return depth < 2 ? branches(depth + 1) : log();
        case 4: return send();
        case 5: return one_in(random_, 2) ? "<cancel sendid=\"x\"/>" : log();
        case 6:
            if (depth >= 2 || !one_in(random_, 2)) { return log(); }
            return "<foreach item=\"each\" array=\"" + any_of(arrays, random_) + "\">" +
                   content(depth + 1) + "</foreach>";
        default: return log();
        }
    }

    std::string content(int depth = 0) {
        std::string out;
        for (std::int64_t i = random_.whole(0, 2); i > 0; --i) {
            out += action(depth);
        }
        return out;
    }

    std::string branches(int depth) {
        std::string out = "<if cond=\"" + condition() + "\">" + content(depth);
        while (one_in(random_, 3)) {
            out += "<elseif cond=\"" + condition() + "\"/>" + content(depth);
        }
        if (one_in(random_, 2)) { out += "<else/>" + content(depth); }
        return out + "</if>";
    }

    std::string transition() {
        std::string out = "<transition";
        const bool eventless = one_in(random_, 8);
        if (!eventless) {
            const std::string event = one_in(random_, 6) ? "done.state." + name(any_state())
                                                         : any_of(descriptors, random_);
            out += " event=\"" + event + '"';
        }
        if (eventless) {
            out += " cond=\"n &lt; " + std::to_string(random_.whole(1, 12)) + '"';
        } else if (one_in(random_, 3)) {
            out += " cond=\"" + condition() + '"';
        }
        if (!one_in(random_, 5)) { out += " target=\"" + targets() + '"'; }
        if (one_in(random_, 3)) { out += " type=\"internal\""; }
        out += '>';
        if (eventless) { out += "<assign location=\"n\" expr=\"n + 1\"/>"; }
        return out + content() + "</transition>";
    }

    std::string state(std::size_t s) {
        static constexpr std::array elements = {"state", "parallel", "final"};
        const State& it = states_[s];
        const std::string element = elements[static_cast<std::size_t>(it.kind)];
        std::string out = '<' + element + " id=\"" + name(s) + '"';
        const bool compound = !it.children.empty() && it.kind == Kind::state;
        const std::int64_t begin = compound ? random_.whole(0, 2) : 0;
        if (begin == 1) { out += " initial=\"" + name(descendant(s)) + '"'; }
        out += '>';
        const bool history_first = one_in(random_, 2);
        for (const std::string& history : it.histories) {
            if (history_first) { out += history; }
        }
        if (begin == 2) {
            out += "<initial><transition target=\"" + name(descendant(s)) + "\">" + content() +
                   "</transition></initial>";
        }
        for (const char* block : {"onentry", "onexit"}) {
            for (std::int64_t i = random_.whole(0, 2); i > 0; --i) {
                out += std::string("<") + block + '>' + content() + "</" + block + '>';
            }
        }
        out += it.invoke;
        if (it.kind != Kind::final) {
            for (std::int64_t i = random_.whole(0, 3); i > 0; --i) {
                out += transition();
            }
        }
        for (const std::size_t child : it.children) {
            out += state(child);
        }
        for (const std::string& history : it.histories) {
            if (!history_first) { out += history; }
        }
        return out + "</" + element + '>';
    }

    Random& random_;
    int inside_;
    std::vector<State> states_;
    std::vector<std::string> histories_, invokes_;  // ids
    int logs_ = 0;
};

}  // namespace

std::string random_machine(Random& random, int states) {
    return Writer(random, states, 0).text();
}

std::string random_event(Random& random) {
    return any_of(names, random);
}

}  // namespace trellis::test
