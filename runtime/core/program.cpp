// The tables of ops.def and status names, comparison and printing of programs.
// SPDX-License-Identifier: MIT
#include "core/program.h"

#include <array>

namespace trellis {

namespace {

constexpr std::uint32_t many = OpInfo::many;
constexpr std::array ops = {
#define OP(name, element, group, least, most, doc)                                                 \
    OpInfo{Op::name, #name, element, OpGroup::group, least, most, doc},
#include "core/ops.def"
};

/// Appends lines of fields to a text.
class Printer {
public:
    explicit Printer(const Program& program) : p_(program) {}

    std::string print() && {
        section("rows");
        for (std::uint32_t i = 0; i < p_.rows.size(); ++i) {
            row({i});
        }
        slots();
        calls();
        transitions();
        actions();
        for (const auto& [n, c] : p_.conditions) {
            conditions(n, c);
        }
        section("code");
        out_ += dump(p_.code);
        for (const MachineSource& s : p_.sources) {
            out_ += "source \"" + s.source + '"';
            field("is machine", s.machine);
            out_ += '\n';
        }
        for (std::size_t i = 0; i < p_.machines.size(); ++i) {
            section("machine " + std::to_string(i));
            out_ += Printer(p_.machines[i]).print();
        }
        return std::move(out_);
    }

private:
    void section(std::string_view title) {
        out_ += title;
        out_ += '\n';
    }
    void field(std::string_view name, std::uint32_t id, bool shown = true) {
        if (!shown) { return; }
        out_ += ' ';
        out_ += name;
        out_ += ' ';
        out_ += std::to_string(id);
    }
    template <class Tag>
    void field(std::string_view name, Id<Tag> id) {
        field(name, id.index, static_cast<bool>(id));
    }

    void row(RowId n) {
        const Row& r = p_.at(n);
        std::size_t depth = 0;
        for (RowId up = r.parent; up; up = p_.at(up).parent) {
            ++depth;
        }
        out_ += std::to_string(n.index) + std::string(2 + 2 * depth, ' ');
        out_ += op_table()[r.op].name;
        out_ += " \"" + p_.names[n.index] + "\"";
        field("end", r.end);
        field("arg", r.arg);
        out_ += r.conditional ? " conditional\n" : "\n";
        if (r.op == Op::run_machine) { machine_node(p_.machine_nodes[r.arg]); }
        const OpGroup group = op_table()[r.op].group;
        if (group == OpGroup::state) { state(p_.state(n)); }
        if (group == OpGroup::activity) { invoke(p_.invokes[r.arg]); }
        if (group == OpGroup::pseudo) {
            out_ += p_.histories[r.arg].deep ? "    deep" : "    shallow";
            field("initial", p_.histories[r.arg].initial);
            out_ += '\n';
        }
    }

    void state(const StateInfo& s) {
        out_ += "   ";
        field("transitions", s.first_transition, s.transition_count > 0);
        field("count", s.transition_count, s.transition_count > 0);
        for (std::uint32_t i = 0; i < s.entry_count; ++i) {
            field("onentry", p_.blocks[s.first_entry + i]);
        }
        for (std::uint32_t i = 0; i < s.exit_count; ++i) {
            field("onexit", p_.blocks[s.first_exit + i]);
        }
        field("initial", s.initial);
        field("invokes", s.invokes, s.invokes > 0);
        field("histories", s.histories, s.histories > 0);
        event("done", s.done);
        payload(s.donedata);
        out_ += '\n';
    }

    void invoke(const InvokeInfo& i) {
        out_ += "    id " + i.id;
        event("success", i.done_success);
        event("failure", i.done_failure);
        for (std::uint32_t k = 0; k < i.param_count; ++k) {
            const InvokeParam& param = p_.params[i.first_param + k];
            field("slot", param.slot);
            field("<- code", param.code);
        }
        event("done", i.done);
        field("machine", i.machine);
        field("source code", i.source);
        field("type code", i.type);
        place(i.id_place);
        payload(i.payload);
        field("finalize", i.finalize);
        out_ += i.autoforward ? " autoforward\n" : "\n";
    }

    void machine_node(const MachineNode& node) {
        field("    machine", node.machine);
        for (std::uint32_t i = 0; i < node.param_count; ++i) {
            const MachineParam& param = p_.machine_params[node.first_param + i];
            out_ += ' ' + param.name + (param.entry ? "" : " = " + trellis::print(param.value));
            field("<-> slot", param.entry);
        }
        out_ += '\n';
    }

    void place(const Place& p) {
        field("id -> slot", p.slot);
        field("id -> store", p.store);
    }

    void payload(PayloadId id) {
        if (!id) { return; }
        const Payload& p = p_.payloads[id.index];
        for (std::uint32_t i = 0; i < p.item_count; ++i) {
            const PayloadItem& item = p_.payload_items[p.first_item + i];
            field(item.name + (item.listed ? " <= code" : " <- code"), item.code);
        }
        field("content code", p.content);
    }

    void text(std::string_view label, const LiveText& t) {
        if (!t.text.empty()) { ((out_ += ' ') += label) += " \"" + t.text + '"'; }
        field(std::string(label) + " code", t.code);
    }

    void send(const Send& s) {
        event("event", s.event);
        field("event code", s.event_code);
        text("target", s.target);
        text("type", s.type);
        if (s.delay != 0.0) { out_ += " delay " + trellis::print(Value::real(s.delay)); }
        field("delay code", s.delay_code);
        if (!s.id.empty()) { out_ += " id \"" + s.id + '"'; }
        place(s.id_place);
        payload(s.payload);
    }

    void event(std::string_view label, EventId e) {
        if (!e) { return; }
        out_ += ' ';
        out_ += label;
        out_ += ' ';
        out_ += e.index == 0 ? "*" : p_.events[e.index].text;
    }

    void slots() {
        section("slots");
        for (std::size_t i = 0; i < p_.slots.size(); ++i) {
            const Slot& s = p_.slots[i];
            out_ += std::to_string(i) + "  " + s.name;
            field("scope", s.scope);
            field("type", static_cast<std::uint32_t>(s.type));
            out_ += " = " + trellis::print(s.initial) + '\n';
        }
    }

    void calls() {
        section("calls");
        for (const LeafCall& c : p_.calls) {
            out_ += "  " + c.type->name;
            field("at", c.offset);
            for (std::uint32_t i = 0; i < c.input_count; ++i) {
                const LiveInput& in = p_.live_inputs[c.first_input + i];
                field(c.type->ports[in.port].name + " <- code", in.code);
            }
            for (std::uint32_t i = 0; i < c.output_count; ++i) {
                const BoundOutput& o = p_.bound_outputs[c.first_output + i];
                field(c.type->ports[o.port].name + " -> slot", o.slot);
            }
            out_ += '\n';
        }
        for (const CodeId port : p_.ports) {
            field("port", port);
        }
        if (!p_.ports.empty()) { out_ += '\n'; }
        nodes();
    }

    void nodes() {
        for (const NodeInfo& node : p_.nodes) {
            out_ += "  node";
            field("ports", node.first_port);
            field("entry", node.entry);
            field("word", node.word);
            field("queue", node.queue);
            out_ += '\n';
        }
        for (const TestInfo& test : p_.tests) {
            out_ += "  test ";
            out_ += name_of(test.status);
            field("status", test.status_script);
            field("on success", test.on_success);
            field("on failure", test.on_failure);
            field("post", test.post);
            field("word", test.word);
            out_ += " after " + std::to_string(test.delay) + " ms\n";
        }
    }

    void transitions() {
        section("transitions");
        for (std::size_t i = 0; i < p_.transitions.size(); ++i) {
            const Transition& t = p_.transitions[i];
            out_ += std::to_string(i) + " ";
            field("from", t.source);
            for (std::uint32_t k = 0; k < t.event_count; ++k) {
                event("on", p_.descriptors[t.first_event + k]);
            }
            field("if", t.guard.code);
            for (std::uint32_t k = 0; k < t.target_count; ++k) {
                field("to", p_.targets[t.first_target + k]);
            }
            field("do", t.block);
            field("domain", t.domain);
            out_ += t.internal ? " internal\n" : "\n";
        }
    }

    void actions() {
        static constexpr std::string_view kinds[] = {"end",   "run",  "assign", "initialise",
                                                     "raise", "log",  "unless", "jump",
                                                     "each",  "send", "cancel", "refuse"};
        section("actions");
        for (std::size_t i = 0; i < p_.actions.size(); ++i) {
            const Action& a = p_.actions[i];
            out_ += std::to_string(i) + "  ";
            out_ += kinds[static_cast<std::size_t>(a.kind)];
            field("code", a.code);
            field("store", a.store);
            field("slot", a.slot);
            event("event", a.event);
            field("to", a.go_to);
            if (a.kind == Action::Kind::log || a.kind == Action::Kind::refuse) {
                out_ += " \"" + p_.labels[a.arg] + '"';
            }
            if (a.kind == Action::Kind::each) {
                field("item", p_.loops[a.arg].item);
                field("index", p_.loops[a.arg].index);
            }
            if (a.kind == Action::Kind::send) { send(p_.sends[a.arg]); }
            out_ += '\n';
        }
    }

    void conditions(RowId n, const Conditions& c) {
        field("conditions of", n);
        field("_failureIf", c.failure_if);
        field("_successIf", c.success_if);
        field("_skipIf", c.skip_if);
        field("_while", c.while_true);
        field("_onSuccess", c.on_success);
        field("_onFailure", c.on_failure);
        field("_onHalted", c.on_halted);
        field("_post", c.post);
        out_ += '\n';
    }

    const Program& p_;
    std::string out_;
};

}  // namespace

OpTable op_table() {
    return {ops.data(), ops.size()};
}

std::string_view name_of(Status status) {
    static constexpr std::string_view names[] = {"IDLE", "RUNNING", "SUCCESS", "FAILURE",
                                                 "SKIPPED"};
    return names[static_cast<std::size_t>(status)];
}

bool operator==(const Program& a, const Program& b) {
    return a.rows == b.rows && a.names == b.names && a.slots == b.slots &&
           a.code.instructions == b.code.instructions && a.code.constants == b.code.constants &&
           a.code.guards == b.code.guards && a.calls == b.calls && a.live_inputs == b.live_inputs &&
           a.formulas == b.formulas && a.formula_steps == b.formula_steps &&
           a.quiet_states == b.quiet_states && a.quiet_sensors == b.quiet_sensors &&
           a.quiet_times == b.quiet_times && a.quiet_inputs == b.quiet_inputs &&
           a.bound_outputs == b.bound_outputs && a.prototypes == b.prototypes &&
           a.leaf_bytes == b.leaf_bytes && a.ports == b.ports && a.nodes == b.nodes &&
           a.tests == b.tests && a.words == b.words && a.queues == b.queues &&
           a.counts_writes == b.counts_writes && a.conditions == b.conditions &&
           a.states == b.states && a.transitions == b.transitions && a.targets == b.targets &&
           a.entered == b.entered && a.takes_plain_events == b.takes_plain_events &&
           a.events == b.events && a.descriptors == b.descriptors && a.actions == b.actions &&
           a.blocks == b.blocks && a.labels == b.labels && a.invokes == b.invokes &&
           a.params == b.params && a.tick_event == b.tick_event && a.error_event == b.error_event &&
           a.event_slot == b.event_slot && a.has_eventless == b.has_eventless && a.host == b.host &&
           a.histories == b.histories && a.has_messages == b.has_messages &&
           a.payloads == b.payloads && a.payload_items == b.payload_items && a.sends == b.sends &&
           a.loops == b.loops && a.parameters == b.parameters &&
           a.machine_nodes == b.machine_nodes && a.machine_params == b.machine_params &&
           a.session_slot == b.session_slot && a.processors_slot == b.processors_slot &&
           a.machines == b.machines && a.sources == b.sources;
}

std::string dump(const Program& program) {
    return Printer(program).print();
}

}  // namespace trellis
