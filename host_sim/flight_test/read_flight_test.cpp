#include "host_sim/flight_test/read_flight_test.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include "host_sim/flight_test/included_scripts.hpp"
#include "host_sim/flight_test/read_expectation.hpp"
#include "host_sim/flight_test/read_steps.hpp"
#include "host_sim/flight_test/stepped_aircraft.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

class FlightTestReader {
public:
    FlightTestReader(const IncludedScripts& scripts, ScriptFaults& faults, const ScriptDefaults& defaults) : faults_(faults) {
        for (const ScriptValue& tree : scripts.files) tables_.emplace_back(tree, faults);
        test_.path = scripts.paths.back();
        test_.files = scripts.paths;
        test_.parameters = scripts.parameters;
        test_.picture.design = defaults.design;
        test_.picture.design_folders = defaults.design_folders;
        test_.picture.device = defaults.device;
        test_.picture.bus = defaults.bus;
        test_.switch_config = defaults.switches;
    }

    FlightTest read() {
        for (ScriptTable& table : tables_) read_settings(table);
        load_bus();
        load_panel();
        load_design_names();
        for (ScriptTable& table : tables_) read_input(table);
        for (ScriptTable& table : tables_) read_steps(table);
        for (ScriptTable& table : tables_) read_expectations(table);
        for (ScriptTable& table : tables_) {
            static_cast<void>(table.take("parameters"));
            static_cast<void>(table.take("include"));
            table.finish();
        }
        check_input();
        check_sources();
        find_contradictions(test_.expectations, faults_);
        if (test_.title.empty()) test_.title = std::filesystem::path(test_.path).stem().string();
        return std::move(test_);
    }

private:
    /// The name of a file that a key states. A bare one is that of a shipped file, where the key has a folder of `configs`.
    void read_file_name(ScriptTable& table, const char* key, const std::string& folder, std::string& target) {
        const auto name = table.text(key);
        if (!name) return;
        target = folder.empty() ? path_from(table.file(), *name) : stated_config(*name, folder, table.file());
        std::error_code error;
        missing_.erase(key);
        if (std::filesystem::is_regular_file(target, error)) return;
        missing_.insert(key);
        table.fault(key, std::string("'") + key + "': there is no file " + target +
                             (folder.empty() ? "; name a path from this file's folder"
                                             : "; name a shipped one, or a path from this file's folder"));
    }

    /// The shipped one of a bare name is built; `folder` of `configs` has it, or it is "jacksboro".
    void read_built_name(ScriptTable& table, const char* key, const char* folder, std::string& target) {
        const auto name = table.text(key);
        if (!name) return;
        if (name->find_first_of("./") != std::string::npos) return read_file_name(table, key, "", target);
        target = *name;
        if (std::string_view(folder).empty()) {
            static_cast<void>(place_among(table, key, *name, {"jacksboro"}));
            return;
        }
        try {
            static_cast<void>(resolve_config(*name, folder));
        } catch (const UserError& error) {
            table.fault(key, std::string("'") + key + "': " + error.what());
        }
    }

    void read_settings(ScriptTable& table) {
        if (const auto title = table.text("title")) test_.title = *title;
        const std::string design = test_.picture.design;
        read_file_name(table, "design", "designs", test_.picture.design);
        if (test_.picture.design != design) test_.picture.design_folders = DesignFolders();
        read_file_name(table, "device", "devices", test_.picture.device);
        read_file_name(table, "bus", "buses", test_.picture.bus);
        read_file_name(table, "switches", "switches", test_.switch_config);
        read_file_name(table, "aircraft", "aircraft", test_.picture.aircraft);
        read_built_name(table, "terrain", "", test_.picture.terrain);
        read_built_name(table, "scene", "scenes", test_.picture.scene);
    }

    /// A sentence of a file that a script names is one of the script's.
    template <class Load>
    void load(const char* key, Load load_it) {
        if (missing_.count(key) != 0) return;
        try {
            load_it();
        } catch (const UserError& error) {
            tables_.back().fault(key, std::string("'") + key + "': " + error.what());
        }
    }

    void load_bus() {
        load("bus", [this] {
            const std::string path = resolve_config(test_.picture.bus, "buses");
            const auto bus = bus::load_bus_settings(read_file(path), path);
            if (!bus.ok()) throw UserError(std::string(bus.error().message.view()));
            test_.bus = bus.value();
        });
    }

    void load_panel() {
        load("switches", [this] {
            const std::string path = resolve_config(test_.switch_config, "switches");
            const auto panel = bus::load_switch_config(read_file(path), path);
            if (!panel.ok()) throw UserError(std::string(panel.error().message.view()));
            test_.panel = panel.value();
        });
    }

    void load_design_names() {
        load("design", [this] { designs_ = design_names(test_.picture); });
    }

    void read_input(ScriptTable& table) {
        if (const ScriptValue* const start = table.take("start"); start != nullptr) add_start(*start);
        const ScriptValue* const value = table.take("input");
        if (value == nullptr) return;
        ScriptTable input(*value, faults_);
        read_file_name(input, "log", "", test_.log);
        read_file_name(input, "switch_log", "", test_.switch_log);
        read_built_name(input, "scenario", "scenarios", test_.scenario);
        if (table.file() == test_.path) test_.input_line = value->line;
        if (const auto lasts = input.number("lasts_s", 0.1, kLatestTestTime_s)) lasts_s_ = *lasts;
        input.finish();
    }

    /// A key takes the place of an included one, in whatever unit that was.
    void add_start(const ScriptValue& start) {
        const auto quantity = [](const std::string& key) { return key.substr(0, key.rfind('_')); };
        std::vector<ScriptValue::Entry> kept;
        for (const ScriptValue::Entry& before : start_.entries)
            if (std::none_of(start.entries.begin(), start.entries.end(),
                             [&](const ScriptValue::Entry& own) { return quantity(own.first) == quantity(before.first); }))
                kept.push_back(before);
        const bool is_table = start.kind == ScriptValue::Kind::table;
        if (!is_table) faults_.add(start.file, start.line, "'start' must be a table, [start]");
        start_ = start;
        start_.kind = ScriptValue::Kind::table;
        start_.entries.insert(start_.entries.end(), kept.begin(), kept.end());
        has_start_ = true;
    }

    void read_steps(ScriptTable& table) {
        for (const ScriptValue* const step : table.tables("step")) {
            ScriptTable section(*step, faults_);
            throws_panel_ = throws_panel_ || section.has("switch") || section.has("lines") || section.has("bounce");
            test_.steps.push_back(read_step(section, test_.bus, test_.panel, faults_));
        }
    }

    void read_expectations(ScriptTable& table) {
        for (const ScriptValue* const expect : table.tables("expect")) {
            ScriptTable section(*expect, faults_);
            test_.expectations.push_back(read_expectation(section, {designs_, test_.picture}, faults_));
        }
    }

    void check_input() {
        ScriptTable& own = tables_.back();
        test_.has_steps = test_.log.empty() && test_.scenario.empty();
        if (!test_.log.empty() && !test_.scenario.empty()) own.fault("input", "[input] says a log and a scenario; remove one");
        if (!test_.switch_log.empty() && test_.log.empty()) own.fault("input", "'switch_log' belongs to a log; say log, too");
        if (!test_.has_steps && !test_.steps.empty())
            faults_.add(test_.steps.front().file, test_.steps.front().line,
                        "a [[step]] beside a log or a scenario; remove [input] or the steps");
        if (test_.expectations.empty()) own.fault("", "the script expects nothing; add an [[expect]]");
        if (!test_.has_steps && has_start_)
            faults_.add(start_.file, start_.line,
                        "[start] belongs to steps, and this script flies a log or a scenario; remove one");
        if (!test_.has_steps && lasts_s_ > 0)
            own.fault("input", "'lasts_s' belongs to steps; a log and a scenario have their own length; remove it");
        ScriptTable start(start_, faults_);
        test_.start = read_start(start);
        std::stable_sort(test_.steps.begin(), test_.steps.end(),
                         [](const TestStep& a, const TestStep& b) { return a.at_s < b.at_s; });
        if (!test_.has_steps) return;
        end_steps();
        check_bounces();
        check_ramps();
    }

    /// Without a switch that is thrown no switch states a phase.
    void check_sources() {
        if (throws_panel_ || !test_.switch_log.empty() || !test_.scenario.empty()) return;
        for (const Expectation& one : test_.expectations)
            for (const FrameCondition& condition : one.conditions)
                if (condition.key == "phase_source" && condition.expected == "switch")
                    faults_.add(
                        one.file, one.line,
                        std::string("'phase_source': no switch is thrown; ") +
                            (test_.has_steps ? "add a [[step]] with switch, lines or bounce" : "say switch_log in [input]") +
                            ", or expect another source");
    }

    /// While a contact bounces nothing else changes the panel: its levels would be those of neither.
    void check_bounces() {
        const TestStep* bounce = nullptr;
        for (const TestStep& step : test_.steps) {
            const bool changes = !step.lines.empty() || step.bounce;
            if (changes && bounce != nullptr && step.at_s < bounce->at_s + bounce->bounce->lasts_s())
                faults_.add(step.file, step.line,
                            "the bounce of " + bounce->file + ":" + std::to_string(bounce->line) +
                                " still goes on at this time; say a later one, or fewer times");
            if (step.bounce) bounce = &step;
        }
    }

    void check_ramps() {
        SteppedAircraft aircraft(test_.start);
        for (const TestStep& step : test_.steps) {
            if (step.ramp.empty() && step.hold.empty()) continue;
            aircraft.advance_to(step.at_s);
            const SignalSample now = aircraft.sample();
            for (const SignalTarget& target : step.ramp)
                if (!now.has(target.signal))
                    faults_.add(step.file, step.line,
                                std::string("the ramp of '") + flight::to_string(target.signal) +
                                    "' begins where it has no value; hold one in an earlier step");
            aircraft.take(step, step.at_s);
        }
    }

    /// The bus goes on until the last expectation, or as long as the script says.
    void end_steps() {
        double last_s = 0;
        for (const Expectation& one : test_.expectations) last_s = std::max(last_s, one.to_s);
        constexpr double kBeyond_s = 0.5;  // so that each expectation has its frame
        test_.end_s = lasts_s_ > 0 ? lasts_s_ : last_s + kBeyond_s;
        for (const TestStep& step : test_.steps)
            if (step.at_s > test_.end_s)
                faults_.add(step.file, step.line,
                            "this [[step]] lies beyond the last expectation; remove it, or expect something");
        for (const Expectation& one : test_.expectations)
            if (one.to_s > test_.end_s)
                faults_.add(one.file, one.line,
                            "this [[expect]] lies beyond the end of the input; raise lasts_s, or say an "
                            "earlier time");
    }

    ScriptFaults& faults_;
    std::vector<ScriptTable> tables_;
    FlightTest test_;
    std::vector<std::string> designs_;
    std::set<std::string> missing_;  ///< keys whose file is not there, as has been told
    ScriptValue start_;              ///< of all files
    bool has_start_ = false, throws_panel_ = false;
    double lasts_s_ = 0;
};

}  // namespace

std::vector<std::string> design_names(const PictureOptions& picture) {
    const std::unique_ptr<LoadedDesigns> designs = load_designs(picture);
    std::vector<std::string> names = {std::string(designs->design.name.view())};
    for (std::size_t n = 1; n <= designs->phases.size(); ++n) names.emplace_back(designs->phases.at(n).name.view());
    return names;
}

FlightTest read_flight_test(const std::string& path, const ScriptParameters& stated, ScriptFaults& faults,
                            const ScriptDefaults& defaults) {
    const IncludedScripts scripts = read_included_scripts(path, stated, faults);
    if (scripts.is_broken) return {};
    return FlightTestReader(scripts, faults, defaults).read();
}

}  // namespace tedavis::host_sim
