// A slow and obvious interpreter of statecharts: Appendix D of the SCXML Recommendation, read off
// the document, not the program. It judges runtime/exec. It knows a few forms of expressions:
//     n + 1   n < 3   n > 3   true   false   In('s')   !In('s')   _x.bumper   [1, 2]
// and takes every other one as an error. Where it leaves Appendix D, as MACHINES asks for:
// done.state goes up through nested parallel states, the domain of a transition to a history is
// what it was before anything was left, an active state is not entered again, and the sessions take
// turns (see cycle()).
// Covered by, and used in, tests/exec/machine_reference_test.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "load/document.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace trellis::test {

class ReferenceMachine {
public:
    /// `document` is a machine file without faults and must outlive it.
    explicit ReferenceMachine(const Document& document) : ReferenceMachine(document, 0, nullptr) {}
    ReferenceMachine(const ReferenceMachine&) = delete;
    ReferenceMachine& operator=(const ReferenceMachine&) = delete;

    /// Enters the initial states and comes to rest.
    void start();
    /// One second passes: what is due is queued behind what waits, then everything comes to rest.
    void cycle();
    /// Puts an event into the external queue.
    void send(std::string_view event) { external_.push_back({.name = std::string(event)}); }

    /// "s1 enter a", "s1 leave a", "s1 take a" (a transition of a), "s1 log text", a line each,
    /// since the start; s2 and so on are invoked machines.
    std::string trace;
    bool bumper = false;
    bool is_running() const { return running_; }
    /// True after more microsteps than any sensible machine takes: the rest means nothing.
    bool is_endless() const { return microsteps_ > 400; }
    /// The ids of the active states, sorted, with blanks between.
    std::string configuration() const;

private:
    using Index = std::uint32_t;  // of an element: document order
    using States = std::set<Index>;

    struct Way {  // a <transition>, or how a state begins
        Index element = 0;
        Index source = 0;
        std::vector<Index> targets;
        bool internal = false;
        Index domain = 0;
    };
    struct Message {
        std::string name;
        Index invoke = 0;  // the <invoke> whose machine sent it; 0: none
        int activation = 0;
        bool completes = false;
    };
    struct Delayed {
        int due;  // s
        std::string target, sendid;
        Message message;
    };
    struct Child;

    ReferenceMachine(const Document& document, Index root, ReferenceMachine* parent);

    // the document
    std::string_view name(Index e) const { return document_.name({e}); }
    std::string_view value(Index e, std::string_view attribute) const {
        return document_.value({e}, attribute);
    }
    std::vector<Index> children(Index e, std::string_view named) const;
    bool is_state(Index s) const;
    bool is_compound(Index s) const;
    bool is_atomic(Index s) const { return child_states(s).empty(); }
    Index parent(Index s) const { return document_.at({s}).parent.index; }
    bool is_descendant(Index s, Index of) const;
    std::vector<Index> child_states(Index s) const;
    std::vector<Index> states_named(std::string_view names) const;
    Way initial_way(Index s) const;
    void say(std::string_view what, Index state);

    // Appendix D
    std::vector<Index> effective_targets(const Way& way) const;
    Index domain(const Way& way) const;
    std::vector<Way> select(const std::string* event);
    bool find_enabled(Index atom, const std::string* event, Way& found);
    bool matches(Index transition, const std::string& event) const;
    std::vector<Way> without_conflicts(const std::vector<Way>& enabled) const;
    States exit_set(const Way& way) const;
    void microstep(const std::vector<Way>& ways);
    void exit_states(const std::vector<Way>& ways);
    void enter_states(const std::vector<Way>& ways);
    struct Entry {
        States states, by_default;
        std::map<Index, Index> history_content;  // by state
    };
    void add_descendants(Index s, Entry& entry) const;
    void add_ancestors(Index s, Index top, Entry& entry) const;
    void add_regions(Index parallel, Entry& entry) const;
    void finish(Index final_state);
    bool is_finished(Index s) const;
    void come_to_rest();
    void exit_interpreter();

    // sessions: reference_content.cpp
    void take_turns(bool begins);
    void take_external();
    void run_child_machines();
    void start_invokes();
    void cancel_invokes(Index state);
    void queue_due();
    bool anything_waits() const;
    bool deliver(std::string_view target, Message message);
    ReferenceMachine* find_session(std::string_view number);

    // executable content: reference_content.cpp
    void run_blocks(Index s, std::string_view element);
    bool run_content(Index parent);
    bool run_action(Index action);
    bool run_branches(Index branches);
    bool run_loop(Index loop);
    bool run_send(Index send);
    bool condition(std::string_view text);
    bool truth(std::string_view text, bool& failed) const;

    const Document& document_;
    const Index root_;
    ReferenceMachine* const parent_;
    ReferenceMachine& outermost_;
    int sessions_ = 0;  // of the outermost machine: how many there were
    const int number_;
    States configuration_;
    std::map<Index, std::vector<Index>> histories_;
    std::deque<std::string> internal_;
    std::deque<Message> external_;
    std::vector<Delayed> delayed_;
    std::set<Index> to_invoke_;
    std::map<Index, int> activations_;
    std::list<Child> children_;
    int n_ = 0;  // the only variable
    int microsteps_ = 0;
    int time_ = 0;   // s
    int begun_ = 0;  // the second whose turn it has begun
    bool running_ = false;
    bool mute_ = false;
    Index outer_invoke_ = 0;
};

struct ReferenceMachine::Child {
    Index invoke;
    ReferenceMachine machine;
    Child(Index i, const Document& document, Index root, ReferenceMachine* parent)
        : invoke(i), machine(document, root, parent) {}
};

}  // namespace trellis::test
