// A slow and obvious interpreter of statecharts: Appendix D of the SCXML Recommendation, read off
// the document, not the program, without parallel, history, send and invoke. It judges
// exec/machine_rules.cpp and exec/configuration.cpp. It knows a few forms of expressions:
//     n + 1   n < 3   n > 3   true   false   In('s')   !In('s')   _x.bumper
// and takes every other one as an error. Covered by, and used in,
// tests/exec/machine_reference_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <deque>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

class ReferenceMachine {
public:
    /// `document` is a machine file without faults and must outlive it.
    explicit ReferenceMachine(const Document& document);

    /// Enters the initial states and comes to rest.
    void start();
    /// Processes one external event.
    void send(std::string_view event);

    /// "enter a", "leave a", "take a" (a transition of a), "log text", a line each, since the
    /// start.
    std::string trace;
    bool bumper = false;
    bool is_running() const { return running_; }
    /// True after more microsteps than any sensible machine takes: the rest means nothing.
    bool is_endless() const { return microsteps_ > 300; }
    /// The ids of the active states, in document order, with blanks between.
    std::string configuration() const;

private:
    using States = std::set<std::uint32_t>;  // indices of elements: document order

    struct Way {            // a <transition>, or how a state begins
        ElementId element;  // none: no content
        std::uint32_t source = 0;
        std::vector<std::uint32_t> targets;
        bool internal = false;
    };

    bool is_state(std::uint32_t s) const;
    bool is_final(std::uint32_t s) const;
    std::uint32_t parent(std::uint32_t s) const;
    bool is_descendant(std::uint32_t s, std::uint32_t of) const;
    std::vector<std::uint32_t> child_states(std::uint32_t s) const;
    std::string id(std::uint32_t s) const;
    std::vector<std::uint32_t> states_named(std::string_view names) const;

    Way initial_way(std::uint32_t s) const;
    std::uint32_t domain(const Way& way) const;
    bool find_enabled(const std::string* event, Way& found);
    bool matches(ElementId transition, const std::string& event) const;

    void microstep(const Way& way);
    void exit_states(const Way& way);
    void enter_states(const Way& way);
    void add_descendants(std::uint32_t s, States& to_enter, States& by_default) const;
    void add_ancestors(std::uint32_t s, std::uint32_t top, States& to_enter) const;
    void come_to_rest();
    void exit_interpreter();

    void run_blocks(std::uint32_t s, std::string_view element);
    /// False if an action failed: the rest of the block is not done.
    bool run_content(ElementId parent);
    bool run_action(ElementId action);
    bool run_branches(ElementId branches);
    bool condition(std::string_view text);
    bool truth(std::string_view text, bool& failed) const;

    const Document& document_;
    States configuration_;
    std::deque<std::string> internal_;
    int n_ = 0;  // the only variable
    int microsteps_ = 0;
    bool running_ = false;
};

}  // namespace trellis::test
