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
constexpr std::array descriptors = {"a",          "b", "c",       "a.x",   "a.*",
                                    "b.",         "*", "a.x.y c", "error", "error.execution",
                                    "done.state", ".*"};
constexpr std::array conditions = {"true", "false", "_x.bumper", "n &lt; 5", "n > 2", "nosuch"};

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
    Writer(Random& random, int states) : random_(random) { make(0, states, 0); }

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
    struct State {
        std::size_t parent = 0;
        bool final = false;
        std::vector<std::size_t> children;
    };

    void make(std::size_t parent, int count, int depth) {
        if (states_.empty()) { states_.emplace_back(); }
        while (count > 0) {
            const std::size_t s = states_.size();
            states_.push_back({.parent = parent, .children = {}});
            states_[parent].children.push_back(s);
            --count;
            if (depth < 4 && count > 0 && one_in(random_, 2)) {
                const int inside = static_cast<int>(random_.whole(1, count));
                count -= inside;
                make(s, inside, depth + 1);
            } else {
                // a machine that ends at once says little
                states_[s].final = states_[parent].children.size() > 1 && one_in(random_, 4);
            }
        }
    }

    static std::string name(std::size_t s) { return 's' + std::to_string(s); }

    std::size_t descendant(std::size_t of) {
        std::size_t s = of;
        do {
            const auto& children = states_[s].children;
            s = children[static_cast<std::size_t>(
                random_.whole(0, static_cast<std::int64_t>(children.size()) - 1))];
        } while (!states_[s].children.empty() && one_in(random_, 2));
        return s;
    }

    std::string any_state() {
        return name(static_cast<std::size_t>(
            random_.whole(1, static_cast<std::int64_t>(states_.size()) - 1)));
    }

    std::string condition() {
        if (one_in(random_, 3)) {
            return (one_in(random_, 2) ? "!In('" : "In('") + any_state() + "')";
        }
        return any_of(conditions, random_);
    }

    std::string log() { return "<log label=\"" + std::to_string(++logs_) + "\"/>"; }

    std::string action(int depth) {
        switch (random_.whole(0, 6)) {
        case 0: return "<raise event=\"" + any_of(names, random_) + "\"/>";
        case 1: return "<assign location=\"n\" expr=\"n + 1\"/>";
        case 2: return one_in(random_, 3) ? "<assign location=\"n\" expr=\"nosuch\"/>" : log();
        case 3:
            if (depth < 2) { return branches(depth + 1); }
            return log();
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
        const bool eventless = one_in(random_, 6);
        if (!eventless) {
            const std::string event =
                one_in(random_, 6) ? "done.state." + any_state() : any_of(descriptors, random_);
            out += " event=\"" + event + '"';
        }
        if (eventless) {
            out += " cond=\"n &lt; " + std::to_string(random_.whole(1, 20)) + '"';
        } else if (one_in(random_, 3)) {
            out += " cond=\"" + condition() + '"';
        }
        if (!one_in(random_, 5)) { out += " target=\"" + any_state() + '"'; }
        if (one_in(random_, 3)) { out += " type=\"internal\""; }
        out += '>';
        if (eventless) { out += "<assign location=\"n\" expr=\"n + 1\"/>"; }
        return out + content() + "</transition>";
    }

    std::string state(std::size_t s) {
        const std::string element = states_[s].final ? "final" : "state";
        std::string out = '<' + element + " id=\"" + name(s) + '"';
        const bool compound = !states_[s].children.empty();
        const std::int64_t begin = compound ? random_.whole(0, 2) : 0;
        if (begin == 1) { out += " initial=\"" + name(descendant(s)) + '"'; }
        out += '>';
        if (begin == 2) {
            out += "<initial><transition target=\"" + name(descendant(s)) + "\">" + content() +
                   "</transition></initial>";
        }
        for (const char* block : {"onentry", "onexit"}) {
            for (std::int64_t i = random_.whole(0, 2); i > 0; --i) {
                out += std::string("<") + block + '>' + content() + "</" + block + '>';
            }
        }
        if (!states_[s].final) {
            for (std::int64_t i = random_.whole(0, 3); i > 0; --i) {
                out += transition();
            }
        }
        for (const std::size_t child : states_[s].children) {
            out += state(child);
        }
        return out + "</" + element + '>';
    }

    Random& random_;
    std::vector<State> states_;
    int logs_ = 0;
};

}  // namespace

std::string random_machine(Random& random, int states) {
    return Writer(random, states).text();
}

std::string random_event(Random& random) {
    return any_of(names, random);
}

}  // namespace trellis::test
