// One run in the recorded format.
// SPDX-License-Identifier: MIT
#include "support/tree_driver.h"

#include "load/load.h"
#include "support/disk.h"
#include "support/script_leaves.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace trellis::test {

namespace {

/// Adds the changes of stored statuses to the events of the host. A node's number counts from 1 at
/// the root, and row 0 is the tree around it.
class TransitionWriter final : public TraceSink {
public:
    explicit TransitionWriter(ScriptHost& host) : host_(host) {}

    void on(const TraceEvent& event) override {
        if (event.kind != TraceEvent::Kind::status || event.row == RowId{0}) { return; }
        static constexpr char letters[] = "IRSFK";
        host_.events += " ~" + std::to_string(event.row.index) + ':';
        host_.events += letters[static_cast<std::size_t>(event.from)];
        host_.events += letters[static_cast<std::size_t>(event.to)];
    }

private:
    ScriptHost& host_;
};

std::string shown(const Value& value) {
    if (value.is(Value::Kind::integer)) { return std::to_string(value.as_integer()); }
    if (value.is(Value::Kind::text)) { return '\'' + value.as_text() + '\''; }
    std::ostringstream out;
    out.precision(10);
    out << value.number();
    return out.str();
}

/// The ID of the tree that a scope row runs: its name, unless the document gives it another.
std::string tree_id(const Program& program, const Document& document, RowId scope) {
    const Origin& origin = program.origins[scope.index];
    for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
        const Where& where = document.elements[i].where;
        const bool here =
            where.line == origin.line && where.column == origin.column && where.file == origin.file;
        if (here && program.at(scope).op == Op::subtree) {
            return std::string(document.value({i}, "ID"));
        }
    }
    return std::string(program.name(scope));
}

std::string blackboards(const Program& program, const Document& document, const State& state) {
    std::string out;
    std::size_t index = 0;
    for (std::uint32_t n = 0; n < program.rows.size(); ++n) {
        const Op op = program.rows[n].op;
        if (op != Op::tree && op != Op::subtree) { continue; }
        std::vector<std::string> entries;
        for (std::size_t i = 0; i < program.slots.size(); ++i) {
            const bool holds = state.entries[i] != EntryType::missing &&
                               !state.slots[i].is(Value::Kind::undefined);
            if (program.slots[i].scope == RowId{n} && holds) {
                entries.push_back(program.slots[i].name + '=' + shown(state.slots[i]));
            }
        }
        std::sort(entries.begin(), entries.end());
        if (!entries.empty()) {
            out += "BB " + std::to_string(index) + ' ' + tree_id(program, document, {n});
            for (const std::string& entry : entries) {
                out += ' ' + entry;
            }
            out += '\n';
        }
        ++index;
    }
    return out;
}

}  // namespace

DriveOptions drive_options(const std::vector<std::string>& words) {
    DriveOptions options;
    for (const std::string& word : words) {
        if (word == "--once") {
            options.once = true;
        } else if (word == "--transitions") {
            options.transitions = true;
        } else if (word == "--no-bb") {
            options.blackboards = false;
        } else if (word.starts_with("--main=")) {
            options.main_tree = word.substr(7);
        } else if (word.starts_with("--halt-at=")) {
            std::istringstream list(word.substr(10));
            for (std::string tick; std::getline(list, tick, ',');) {
                options.halts.insert(std::stoull(tick));
            }
        } else {
            options.ticks = std::stoull(word);
        }
    }
    return options;
}

Drive drive_tree(const std::string& path, const DriveOptions& options) {
    Drive drive;
    Disk reader;
    Diagnostics diagnostics;
    LoadOptions how{.reader = &reader, .main_tree = options.main_tree};
    const Source source = reader.read(path, {}, {}).value_or(Source{path, {}});
    const std::optional<Program> program = load(source, script_registry(), diagnostics, how);
    if (!program) {
        drive.output = "LOAD_ERROR\n";
        drive.messages = diagnostics.render();
        return drive;
    }
    Diagnostics again;
    const Document document = *read(source, again, how);
    ScriptRun run(*program);
    TransitionWriter writer(run.host);
    const StepOptions step{
        .dt = 1.0, .trace = options.transitions ? &writer : nullptr, .while_woken = options.once};
    for (std::uint64_t tick = 1; tick <= options.ticks; ++tick) {
        const Status status = run.step(step);
        const bool failed = static_cast<bool>(run.state.fault);
        drive.output += std::to_string(tick) + ' ' +
                        std::string(failed ? "EXCEPTION" : name_of(status)) + run.host.events +
                        '\n';
        run.host.events.clear();
        if (failed) {
            drive.messages = describe_fault(*program, run.state);
            break;
        }
        if (options.halts.contains(tick)) {
            run.halt(step);
            drive.output += std::to_string(tick) + "h HALTED" + run.host.events + '\n';
            run.host.events.clear();
        }
    }
    if (options.blackboards) { drive.output += blackboards(*program, document, run.state); }
    return drive;
}

}  // namespace trellis::test
