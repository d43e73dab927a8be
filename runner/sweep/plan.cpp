// Loading what a sweep file names, and numbering the runs.
// SPDX-License-Identifier: MIT
#include "runner/sweep/plan.h"

#include "load/text.h"
#include "runner/world_argument.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

namespace trellis {
namespace {

std::uint64_t ticks_of(double seconds, double dt) {
    return static_cast<std::uint64_t>(std::max(1LL, std::llround(seconds / dt)));
}

/// FNV-1a, one text after the other.
class Fingerprint {
public:
    void add(std::string_view text) {
        for (const char c : text)
            add(static_cast<unsigned char>(c));
        add(0xFF);  // no text has that byte: "ab" "c" is not "a" "bc"
    }
    std::uint64_t value() const { return value_; }

private:
    void add(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001B3; }

    std::uint64_t value_ = 0xCBF29CE484222325;
};

}  // namespace

/// Fills a plan.
class SweepPlan::Loader {
public:
    Loader(const std::string& file, SweepPlan& plan, Streams& streams, Exit& exit)
        : folder_(std::filesystem::path(file == "-" ? "" : file).parent_path()), plan_(plan),
          streams_(streams), exit_(exit) {}

    bool load(const std::string& file) {
        if (!load_spec(file)) return false;
        const SweepSpec& spec = plan_.spec_;
        for (const SpecText& world : spec.worlds) {
            if (!load_world_and_floor(world.text)) return false;
        }
        for (std::size_t i = 0; i < spec.behaviours.size(); ++i) {
            if (!load_behaviours(i)) return false;
        }
        for (const double time : spec.times)
            plan_.measuring_.stops.push_back(ticks_of(time, spec.dt));
        plan_.measuring_.leaps = spec.fast;
        const std::uint64_t last = plan_.measuring_.stops.back();
        for (std::uint64_t step = 1; step <= curve_steps; ++step)
            plan_.measuring_.curve.push_back(last * step / curve_steps);
        for (const double mark : spec.marks)
            plan_.measuring_.curve.push_back(ticks_of(mark, spec.dt));
        plan_.fingerprint_ = fingerprint_.value();
        return true;
    }

private:
    bool load_spec(const std::string& file) {
        exit_ = Exit::file;
        const std::optional<std::string> text = read_text(file, streams_, DocumentLimits().bytes);
        if (!text) return false;
        exit_ = Exit::no;
        const std::uint32_t number = spec_findings_.add_file(shown_name(file), *text);
        std::optional<SweepSpec> spec = read_sweep(*text, number, spec_findings_);
        if (!spec) return show_spec_findings();
        plan_.spec_ = std::move(*spec);
        fingerprint_.add(*text);
        return true;
    }

    bool show_spec_findings() {
        spec_findings_.sort();
        show(spec_findings_, streams_);
        return false;
    }

    std::string path_of(const std::string& written) const {
        return (folder_ / written).lexically_normal().string();
    }

    bool load_world_and_floor(const std::string& name) {
        const double cell = plan_.spec_.cell;
        plan_.world_files_.push_back(name == "lab" ? name : path_of(name));
        if (name == "lab") {
            plan_.worlds_.push_back(nullptr);
            plan_.floors_.push_back(std::make_unique<Floor>(floor_of(LabWorld{}, cell)));
            return true;
        }
        const std::string path = path_of(name);
        std::optional<WalledWorld> world = load_world(path, streams_, exit_);
        if (!world) return false;
        std::string why;
        fingerprint_.add(streams_.files.read(path, std::string::npos, why).value_or(""));
        const Pose start = world->plan.starts.front();
        plan_.floors_.push_back(
            std::make_unique<Floor>(floor_of(world->walls, {start.x, start.y}, cell)));
        plan_.worlds_.push_back(std::make_unique<WalledWorld>(std::move(*world)));
        return true;
    }

    /// The behaviour with every combination of its parameters, in every world.
    bool load_behaviours(std::size_t number) {
        const SweepSpec& spec = plan_.spec_;
        const SpecBehaviour& behaviour = spec.behaviours[number];
        exit_ = Exit::file;
        const std::string path = path_of(behaviour.file.text);
        const std::optional<std::string> text = read_text(path, streams_, DocumentLimits().bytes);
        if (!text) return false;
        const Source source{path, *text};
        if (!check_variables(behaviour, source)) return false;
        std::vector<std::size_t> choice(spec.parameters.size());
        do {
            SweepCase one{.behaviour = number, .program = plan_.programs_.size(), .values = {}};
            LoadArguments arguments;
            arguments.main_tree = behaviour.tree;
            for (const SpecBehaviour::Setting& setting : behaviour.set)
                arguments.set.push_back(setting.name.text + '=' + setting.value);
            for (std::size_t i = 0; i < choice.size(); ++i) {
                const SpecParameter& parameter = spec.parameters[i];
                one.values.push_back(parameter.is_of(behaviour) ? parameter.values[choice[i]] : "");
                if (parameter.is_of(behaviour))
                    arguments.set.push_back(parameter.name.text + '=' + one.values.back());
            }
            std::optional<Behaviour> loaded =
                compile_behaviour(source, arguments, plan_.registry_, streams_);
            exit_ = Exit::no;
            if (!loaded->program) return show_findings(*loaded);
            plan_.programs_.push_back(std::move(*loaded));
            for (one.world = 0; one.world < spec.worlds.size(); ++one.world)
                plan_.cases_.push_back(one);
        } while (next(choice, behaviour));
        return true;
    }

    /// The next combination; false after the last.
    bool next(std::vector<std::size_t>& choice, const SpecBehaviour& behaviour) const {
        for (std::size_t i = choice.size(); i-- > 0;) {
            const SpecParameter& parameter = plan_.spec_.parameters[i];
            if (!parameter.is_of(behaviour)) continue;
            if (++choice[i] < parameter.values.size()) return true;
            choice[i] = 0;
        }
        return false;
    }

    /// Loads the file with first values, shows what is wrong with it, and finds the variables that
    /// the sweep sets and the file does not have; their places are in the sweep file.
    bool check_variables(const SpecBehaviour& behaviour, const Source& source) {
        LoadArguments arguments;
        arguments.main_tree = behaviour.tree;
        const std::optional<Behaviour> plain =
            compile_behaviour(source, arguments, plan_.registry_, streams_);
        for (const SpecBehaviour::Setting& setting : behaviour.set) {
            arguments.set.push_back(setting.name.text + '=' + setting.value);
            if (plain->program) check_variable(setting.name, behaviour, *plain->program);
        }
        for (const SpecParameter& parameter : plan_.spec_.parameters) {
            if (!parameter.is_of(behaviour)) continue;
            arguments.set.push_back(parameter.name.text + '=' + parameter.values.front());
            if (plain->program) check_variable(parameter.name, behaviour, *plain->program);
        }
        exit_ = Exit::no;
        if (!spec_findings_.ok()) return show_spec_findings();
        // some files are whole only with the values that they are given
        const std::optional<Behaviour> given =
            compile_behaviour(source, arguments, plan_.registry_, streams_);
        show(given->diagnostics, streams_);
        for (std::uint32_t i = 0; i < given->diagnostics.file_count(); ++i)
            fingerprint_.add(given->diagnostics.file_text(i));
        return given->program.has_value();
    }

    void check_variable(const SpecText& name, const SpecBehaviour& behaviour,
                        const Program& program) {
        std::vector<std::string> paths;
        for (const Slot& slot : program.slots)
            paths.push_back(trellis::path_of(program, slot));
        if (std::find(paths.begin(), paths.end(), name.text) != paths.end()) return;
        spec_findings_.error("unknown-variable", name.where,
                             trellis::quoted(behaviour.name) + " has no variable " +
                                 trellis::quoted(name.text) +
                                 suggestion(name.text, {paths.begin(), paths.end()}));
    }

    bool show_findings(const Behaviour& loaded) {
        show(loaded.diagnostics, streams_);
        return false;
    }

    std::filesystem::path folder_;
    SweepPlan& plan_;
    Streams& streams_;
    Exit& exit_;
    Diagnostics spec_findings_;
    Fingerprint fingerprint_;
};

std::unique_ptr<SweepPlan> SweepPlan::load(const std::string& file, Streams& streams, Exit& exit) {
    std::unique_ptr<SweepPlan> plan(new SweepPlan);
    if (!Loader(file, *plan, streams, exit).load(file)) return nullptr;
    exit = Exit::yes;
    return plan;
}

EpisodeSetup SweepPlan::setup_of(std::uint64_t run) const {
    const std::int64_t seed = seed_of(run);
    return {.walled = world(case_of(run)),
            .dt = spec_.dt,
            .random = Random(seed),
            .noise = noise_of(seed)};
}

MeasuredRun SweepPlan::measure(std::uint64_t run) const {
    const SweepCase& one = case_of(run);
    return measured_run(program(one), setup_of(run), floor(one), measuring_);
}

}  // namespace trellis
