// The scripted leaves and their registration.
// SPDX-License-Identifier: MIT
#include "support/script_leaves.h"

#include "core/number.h"

#include <array>
#include <cstdio>

namespace trellis::test {

namespace {

std::string shown(std::int32_t value) {
    return std::to_string(value);
}
std::string shown(double value) {
    std::array<char, 32> text = {};
    std::snprintf(text.data(), text.size(), "%.10g", value);
    return text.data();
}
std::string shown(std::string_view value) {
    return '\'' + std::string(value) + '\'';
}
std::string shown(const Value& value) {
    switch (value.kind()) {
    case Value::Kind::integer: return std::to_string(value.as_integer());
    case Value::Kind::boolean:
    case Value::Kind::real: return shown(value.number());
    case Value::Kind::text: return shown(std::string_view(value.as_text()));
    default: return print(value);
    }
}

struct ScriptedLeaf {
    std::string_view id, script;

    Status tick(ScriptHost& host, const Tick&) const {
        const Status status = host.next(script);
        host.report(id, ':', name_of(status));
        return status;
    }
    void halt(ScriptHost& host) const { host.report(id, ':', "HALT"); }
};

struct ScriptedSync {
    std::string_view id, script;

    Status tick(ScriptHost& host, const Tick&) const {
        const Status status = host.next(script);
        host.report(id, ':', name_of(status));
        return status;
    }
};

constexpr std::string_view letters = "SFRK-";

Status tick_coded(ScriptHost& host, std::int32_t id, std::int32_t script) {
    std::array<char, 14> text = {};
    std::size_t size = 0;
    for (std::int32_t rest = script; rest > 0; rest /= 5) {
        text[size++] = letters[static_cast<std::size_t>((rest + 4) % 5)];
    }
    const Status status = host.next({text.data(), size});
    host.report(leaf_id(static_cast<std::size_t>(id)), ':', name_of(status));
    return status;
}

struct CodedLeaf {
    std::int32_t id = 0, script = 0;

    Status tick(ScriptHost& host, const Tick&) const { return tick_coded(host, id, script); }
};

struct CodedSync {
    std::int32_t id = 0, script = 0;

    Status tick(ScriptHost& host, const Tick&) const { return tick_coded(host, id, script); }
};

struct Echo {
    std::string_view id;
    const Value* in = nullptr;

    Status tick(ScriptHost& host, const Tick&) const {
        const bool readable = in != nullptr && !in->is(Value::Kind::undefined);
        if (host.records) { host.report(id, '=', readable ? shown(*in) : "ERR"); }
        return readable ? Status::success : Status::failure;
    }
};

template <class T>
struct Get {
    std::string_view id;
    Maybe<T> in;

    Status tick(ScriptHost& host, const Tick&) const {
        if (host.records) { host.report(id, '=', in ? shown(*in) : "ERR"); }
        return in ? Status::success : Status::failure;
    }
};

template <class T>
struct Put {
    std::string_view id;
    Maybe<T> value;
    Out<T> out;

    Status tick(ScriptHost& host, const Tick&) {
        if (value) { out = *value; }
        if (host.records) { host.report(id, '>', value ? shown(*value) : "ERR"); }
        return value ? Status::success : Status::failure;
    }
};

template <class T>
void register_ports(Registry& registry, const std::string& type) {
    registry.add<Get<T>, ScriptHost>("Get" + type, "report a port")
        .input("id", &Get<T>::id)
        .input("in", &Get<T>::in)
        .synchronous();
    registry.add<Put<T>, ScriptHost>("Put" + type, "write a port")
        .input("id", &Put<T>::id)
        .input("value", &Put<T>::value)
        .output("out", &Put<T>::out)
        .synchronous();
}

}  // namespace

void ScriptHost::report(std::string_view id, char mark, std::string_view what) {
    if (!records) { return; }
    events += ' ';
    events += id;
    events += mark;
    events += what;
}

Status ScriptHost::next(std::string_view script) {
    if (script.empty()) { return Status::failure; }
    switch (script[calls[leaf->index]++ % script.size()]) {
    case 'S': return Status::success;
    case 'R': return Status::running;
    case 'K': return Status::skipped;
    default: return Status::failure;
    }
}

void register_scripts(Registry& registry) {
    registry.add<ScriptedLeaf, ScriptHost>("Leaf", "answer as the script says")
        .input("id", &ScriptedLeaf::id)
        .input("script", &ScriptedLeaf::script)
        .required();
    for (const char* name : {"SyncLeaf", "Cond"}) {
        registry.add<ScriptedSync, ScriptHost>(name, "answer at once as the script says")
            .input("id", &ScriptedSync::id)
            .input("script", &ScriptedSync::script)
            .required()
            .synchronous();
    }
    registry.add<CodedLeaf, ScriptHost>("CodedLeaf", "answer as the number says")
        .input("id", &CodedLeaf::id)
        .input("script", &CodedLeaf::script)
        .required();
    registry.add<CodedSync, ScriptHost>("CodedSyncLeaf", "answer at once as the number says")
        .input("id", &CodedSync::id)
        .input("script", &CodedSync::script)
        .required()
        .synchronous();
    registry.add<Echo, ScriptHost>("Echo", "report an untyped port")
        .input("id", &Echo::id)
        .input("in", &Echo::in)
        .synchronous();
    register_ports<std::int32_t>(registry, "Int");
    register_ports<double>(registry, "Double");
    register_ports<std::string_view>(registry, "Str");
    registry.sensor("bumper", &ScriptHost::bumper, "", "a switch");
    registry.sensor("range", &ScriptHost::range, "m", "a distance");
    registry.sensor("count", &ScriptHost::count, "", "a number");
    registry.enumerator("RED", 1);
    registry.enumerator("GREEN", 2);
    registry.enumerator("BLUE", 3);
}

std::int32_t code_of(std::string_view script) {
    std::int32_t code = 0;
    for (std::size_t i = script.size(); i-- != 0;) {
        code = 5 * code + static_cast<std::int32_t>(letters.find(script[i])) + 1;
    }
    return code;
}

std::string leaf_id(std::size_t n) {
    std::string id(1, static_cast<char>('a' + n % 26));
    return n < 26 ? id : leaf_id(n / 26 - 1) + id;
}

const Registry& script_registry() {
    static const Registry& registry = [&]() -> Registry& {
        static Registry made;
        register_scripts(made);
        return made;
    }();
    return registry;
}

ScriptRun::ScriptRun(const Program& program) : state(fresh_state(program)), program_(&program) {
    host.calls.resize(program.rows.size());
}

void ScriptRun::point_host() {
    host.leaf = &state.last_leaf;
}

Status ScriptRun::step(const StepOptions& options) {
    point_host();
    return trellis::step(*program_, state, host, options);
}

void ScriptRun::start(const StepOptions& options) {
    point_host();
    trellis::start(*program_, state, host, options);
}

void ScriptRun::halt(const StepOptions& options) {
    point_host();
    trellis::halt(*program_, state, host, options);
}

std::string ScriptRun::take_events() {
    std::string out = host.events.empty() ? std::string() : host.events.substr(1);
    host.events.clear();
    return out;
}

std::string ScriptRun::statuses() const {
    std::string out;
    for (const Status status : state.status) {
        out += "-RSFK"[static_cast<std::size_t>(status)];
    }
    return out;
}

}  // namespace trellis::test
