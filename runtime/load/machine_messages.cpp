// <send>, <cancel> and what messages carry (SCXML 5.5 to 5.7, 6.2, 6.3).
// SPDX-License-Identifier: MIT
#include "core/number.h"
#include "load/machine_compiler.h"
#include "load/words.h"

#include <optional>
#include <utility>

namespace trellis {

void MachineCompiler::send(ElementId e, RowId state) {
    Program& program = builder_.program;
    Send send;
    if (const Attribute* const name = document().find(e, "event"); name != nullptr) {
        send.event = event(document().string(name->value));
    }
    send.event_code = expression(e, "eventexpr", state);
    send.target = live_text(e, "target", state);
    send.type = live_text(e, "type", state);
    send.delay_code = expression(e, "delayexpr", state);
    send.id = document().value(e, "id");
    if (const Attribute* const delay = document().find(e, "delay"); delay != nullptr) {
        const std::string_view text = document().string(delay->value);
        const std::optional<double> seconds = parse_duration(text);
        if (!seconds) {
            builder_.diagnostics().error("bad-value", delay->value_where,
                                         "\"delay\": expected a duration such as 1.5s or 200ms, "
                                         "found \"" +
                                             std::string(text) + '"');
        }
        send.delay = seconds.value_or(0.0);
    }
    if (const Attribute* const location = document().find(e, "idlocation"); location != nullptr) {
        send.id_place = place(*location, state);
    }
    send.payload = payload(e, state);
    program.has_messages |= send.delay > 0.0 || send.delay_code;
    add_action(Action::Kind::send).arg = static_cast<std::uint32_t>(program.sends.size());
    program.sends.push_back(std::move(send));
}

void MachineCompiler::cancel(ElementId e, RowId state) {
    const Attribute* const id = document().find(e, "sendid");
    const CodeId code = id != nullptr ? builder_.constant(Value::text(document().string(id->value)),
                                                          Dialect::machine)
                                      : expression(e, "sendidexpr", state);
    add_action(Action::Kind::cancel).code = code;
}

// The namelist and the <param>s of an element, or its <content>; none if it has none of them. The
// <content> of an invoke is the machine itself.
PayloadId MachineCompiler::payload(ElementId e, RowId state) {
    Program& program = builder_.program;
    Payload payload;
    std::vector<PayloadItem> items;
    if (const Attribute* const list = document().find(e, "namelist"); list != nullptr) {
        for (const std::string_view word : words(document().string(list->value))) {
            Builder::Text text = Builder::text_of(file_, *list);
            text.text = word;
            MachineNames names(builder_, scope_, state, text);
            const CodeId code =
                builder_.expression(text, Dialect::machine, SyntaxMode::location, names);
            items.push_back({std::string(word), code, true});
        }
    }
    for (const ElementId c : document().children(e)) {
        if (document().name(c) == "param") {
            const CodeId code = param_code(c, state);
            items.push_back({std::string(document().value(c, "name")), code, false});
        } else if (document().name(c) == "content" && document().name(e) != "invoke") {
            const Attribute* const expr = document().find(c, "expr");
            payload.content = expr != nullptr ? expression(*expr, state) : text_value(c, state);
            if (expr == nullptr && !payload.content) {
                payload.content = builder_.constant(Value::text(""), Dialect::machine);
            }
        }
    }
    if (payload.content && !items.empty()) {
        builder_.diagnostics().error("conflicting-parts", document().at(e).where,
                                     "<content> is all that is passed on: there can be no <param> "
                                     "beside it");
    }
    if (!payload.content && items.empty()) { return {}; }
    payload.first_item = static_cast<std::uint32_t>(program.payload_items.size());
    payload.item_count = static_cast<std::uint32_t>(items.size());
    program.payload_items.insert(program.payload_items.end(), items.begin(), items.end());
    program.payloads.push_back(payload);
    return {static_cast<std::uint32_t>(program.payloads.size() - 1)};
}

LiveText MachineCompiler::live_text(ElementId e, const std::string& name, RowId state) {
    return {std::string(document().value(e, name)), expression(e, name + "expr", state)};
}

Place MachineCompiler::place(const Attribute& location, RowId state) {
    const Builder::Text text = Builder::text_of(file_, location);
    MachineNames names(builder_, scope_, state, text);
    const CodeId store = builder_.store(text, names);
    const auto variable = scope_.variables.find(std::string(text.text));
    if (variable != scope_.variables.end()) { return {.slot = variable->second, .store = {}}; }
    return {.slot = {}, .store = store};
}

}  // namespace trellis
