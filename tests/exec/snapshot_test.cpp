// A run that is saved at any tick, written to disk and read back by another process goes on there
// as it does here. The other process is this executable once more, which is told the folder in
// TRELLIS_SNAPSHOTS.
// SPDX-License-Identifier: MIT
#include "support/files.h"
#include "support/loading.h"
#include "support/random_machine.h"
#include "support/random_tree.h"
#include "support/script_leaves.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace trellis::test {
namespace {

namespace fs = std::filesystem;

constexpr int ticks = 10;
constexpr int programs = 40;

/// A child session, messages that wait, a history and data of every kind: all in one state.
const char* const session = R"scxml(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0"
    datamodel="script" initial="a">
  <datamodel><data id="list" expr="[1, 'two', {'three': 3.5}]"/><data id="n" expr="0"/></datamodel>
  <state id="a">
    <onentry><send event="late" delay="3s"/><send event="later" delay="5s"/></onentry>
    <invoke id="inner"><content>
      <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" datamodel="script">
        <datamodel><data id="k" expr="0"/></datamodel>
        <state id="i"><transition event="tick"><assign location="k" expr="k + 1"/>
          <send target="#_parent" event="count" namelist="k"/></transition></state>
      </scxml>
    </content></invoke>
    <state id="b"><transition event="tick" target="c"/></state>
    <state id="c"><invoke type="leaf" src="Leaf"><param name="id" expr="'leaf'"/>
      <param name="script" expr="'RRS'"/></invoke><transition event="done.invoke" target="b"/></state>
    <history id="h"><transition target="b"/></history>
    <transition event="count"><assign location="n" expr="n + _event.data.k"/>
      <assign location="list" expr="append(list, n)"/></transition>
    <transition event="late later" target="d"/>
  </state>
  <state id="d"><transition event="tick" target="h"/></state>
</scxml>)scxml";

std::string text_of(int i, Random& random) {
    if (i == 0) { return session; }
    const int size = static_cast<int>(random.whole(2, 60));
    return i % 2 == 0 ? random_machine(random, size) : xml_of(random_tree(random, size));
}

fs::path file(const fs::path& folder, int program, const std::string& name) {
    return folder / (std::to_string(program) + '.' + name);
}

void write(const fs::path& path, std::string_view text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// What a tick does, as a line: what the leaves said, and everything that later ticks depend on.
std::string tick(ScriptRun& run, const std::string& input) {
    if (run.state.fault) { return "-"; }
    const std::string event = input.substr(1);
    run.host.bumper = input[0] == '1';
    if (!event.empty()) { send(run.program(), run.state, event); }
    const Status status = run.step({.dt = 1.0, .budget = 3000});
    return std::string(name_of(status)) + ' ' + run.statuses() + ' ' + run.take_events() + ' ' +
           std::to_string(hash(run.program(), run.state));
}

/// The state, and how often each leaf was called, which its host counts.
void save_run(const ScriptRun& run, const fs::path& folder, int program, int at) {
    const std::vector<std::byte> bytes = save(run.program(), run.state);
    write(file(folder, program, std::to_string(at)),
          {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    std::string calls;
    for (const std::uint32_t count : run.host.calls) {
        calls += std::to_string(count) + ' ';
    }
    write(file(folder, program, std::to_string(at) + ".calls"), calls);
}

std::optional<ScriptRun> restore_run(const Program& program, const fs::path& folder, int number,
                                     int at) {
    const std::string bytes = read_file(file(folder, number, std::to_string(at)));
    ScriptRun run(program);
    std::optional<State> state =
        restore(program, std::as_bytes(std::span<const char>(bytes.data(), bytes.size())));
    if (!state) { return {}; }
    run.state = std::move(*state);
    std::istringstream calls(read_file(file(folder, number, std::to_string(at) + ".calls")));
    run.host.calls.clear();
    for (std::uint32_t count = 0; calls >> count;) {
        run.host.calls.push_back(count);
    }
    return run;
}

/// The lines of the rest of a run, from tick `at` on.
std::string future(ScriptRun run, const std::vector<std::string>& inputs, int at) {
    std::string lines;
    for (std::size_t i = static_cast<std::size_t>(at); i < inputs.size(); ++i) {
        lines += tick(run, inputs[i]) + '\n';
    }
    return lines;
}

}  // namespace

TEST_CASE("snapshot: the other process") {
    const char* const given = std::getenv("TRELLIS_SNAPSHOTS");
    if (given == nullptr) { return; }  // the test below starts it
    const fs::path folder = given;
    for (int i = 0; i < programs; ++i) {
        const Program program = loaded(read_file(file(folder, i, "text")));
        std::vector<std::string> inputs;
        std::istringstream in(read_file(file(folder, i, "inputs")));
        for (std::string line; std::getline(in, line);) {
            inputs.push_back(line);
        }
        for (int at = 0; at < ticks; ++at) {
            const std::optional<ScriptRun> run = restore_run(program, folder, i, at);
            write(file(folder, i, std::to_string(at) + ".future"),
                  run ? future(*run, inputs, at) : "not restored");
        }
    }
}

TEST_CASE("snapshot: saved at any tick, another process goes on as this one does") {
    const fs::path self = fs::read_symlink("/proc/self/exe");
    std::string name = (fs::temp_directory_path() / "trellis-snapshots-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    const fs::path folder = name;
    Random random(std::int64_t{45});
    std::vector<std::string> expected;
    for (int i = 0; i < programs; ++i) {
        const std::string text = text_of(i, random);
        const Program program = loaded(text);
        std::vector<std::string> inputs;
        std::string lines;
        for (int at = 0; at < ticks; ++at) {
            const std::string event = program.is_machine() ? random_event(random) : "";
            inputs.push_back((random.whole(0, 1) == 0 ? "0" : "1") + event);
            lines += inputs.back() + '\n';
        }
        write(file(folder, i, "text"), text);
        write(file(folder, i, "inputs"), lines);
        ScriptRun run(program);
        for (int at = 0; at < ticks; ++at) {
            save_run(run, folder, i, at);
            expected.push_back(future(run, inputs, at));
            tick(run, inputs[static_cast<std::size_t>(at)]);
        }
    }
    const std::string command = "TRELLIS_SNAPSHOTS='" + folder.string() + "' '" + self.string() +
                                "' --test-case='snapshot: the other process' > /dev/null";
    REQUIRE(std::system(command.c_str()) == 0);
    for (int i = 0; i < programs; ++i) {
        for (int at = 0; at < ticks; ++at) {
            CAPTURE(i);
            CAPTURE(at);
            CHECK(read_file(file(folder, i, std::to_string(at) + ".future")) ==
                  expected[static_cast<std::size_t>(i * ticks + at)]);
        }
    }
    fs::remove_all(folder);
}

}  // namespace trellis::test
