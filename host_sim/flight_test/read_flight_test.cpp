#include "host_sim/flight_test/read_flight_test.hpp"

#include <algorithm>
#include <filesystem>

#include "host_sim/flight_test/included_scripts.hpp"
#include "host_sim/flight_test/read_expectation.hpp"
#include "host_sim/flight_test/read_steps.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

class FlightTestReader {
public:
    FlightTestReader(const IncludedScripts& scripts, ScriptFaults& faults) : faults_(faults) {
        for (const ScriptValue& tree : scripts.files) tables_.emplace_back(tree, faults);
        test_.path = scripts.paths.back();
        test_.files = scripts.paths;
        test_.picture.device = "es2-small";
        test_.switch_config = "one_hot";
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
        find_contradictions(test_.expectations, faults_);
        if (test_.title.empty()) test_.title = std::filesystem::path(test_.path).stem().string();
        return std::move(test_);
    }

private:
    /// The name of a file that a key states: a bare one is left as it is where the key's folder is empty.
    void read_file_name(ScriptTable& table, const char* key, const std::string& folder, std::string& target) {
        const auto name = table.text(key);
        if (!name) return;
        const bool is_bare = name->find_first_of("./") == std::string::npos;
        target = is_bare && folder.empty() ? *name : stated_config(*name, folder, table.file());
        std::error_code error;
        if ((!is_bare || !folder.empty()) && !std::filesystem::is_regular_file(target, error))
            table.fault(key, std::string("'") + key + "': there is no file " + target +
                                 "; name a shipped one, or a path from this file's folder");
    }

    void read_settings(ScriptTable& table) {
        if (const auto title = table.text("title")) test_.title = *title;
        read_file_name(table, "design", "designs", test_.picture.design);
        read_file_name(table, "device", "devices", test_.picture.device);
        read_file_name(table, "bus", "buses", test_.picture.bus);
        read_file_name(table, "switches", "switches", test_.switch_config);
        read_file_name(table, "aircraft", "aircraft", test_.picture.aircraft);
        read_file_name(table, "terrain", "", test_.picture.terrain);
        read_file_name(table, "scene", "", test_.picture.scene);
    }

    /// A sentence of a file that a script names is one of the script's.
    template <class Load>
    void load(const char* key, Load load_it) {
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
        load("design", [this] {
            const std::unique_ptr<LoadedDesigns> designs = load_designs(test_.picture);
            designs_.emplace_back(designs->design.name.view());
            for (std::size_t n = 1; n <= designs->phases.size(); ++n) designs_.emplace_back(designs->phases.at(n).name.view());
        });
    }

    void read_input(ScriptTable& table) {
        if (const ScriptValue* const start = table.take("start"); start != nullptr) {
            ScriptTable section(*start, faults_);
            test_.start = read_start(section);
            has_start_ = true;
        }
        const ScriptValue* const value = table.take("input");
        if (value == nullptr) return;
        ScriptTable input(*value, faults_);
        read_file_name(input, "log", "", test_.log);
        read_file_name(input, "switch_log", "", test_.switch_log);
        if (const auto scenario = input.text("scenario")) test_.scenario = *scenario;
        if (const auto lasts = input.number("lasts_s", 0.1, kLatestTestTime_s)) lasts_s_ = *lasts;
        input.finish();
    }

    void read_steps(ScriptTable& table) {
        for (const ScriptValue* const step : table.tables("step")) {
            ScriptTable section(*step, faults_);
            test_.steps.push_back(read_step(section, test_.bus, test_.panel, faults_));
        }
    }

    void read_expectations(ScriptTable& table) {
        for (const ScriptValue* const expect : table.tables("expect")) {
            ScriptTable section(*expect, faults_);
            test_.expectations.push_back(read_expectation(section, designs_, faults_));
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
        if (!has_start_) {
            const ScriptValue empty;
            ScriptTable section(empty, faults_);
            test_.start = read_start(section);
        }
        std::stable_sort(test_.steps.begin(), test_.steps.end(),
                         [](const TestStep& a, const TestStep& b) { return a.at_s < b.at_s; });
        if (test_.has_steps) end_steps();
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
    bool has_start_ = false;
    double lasts_s_ = 0;
};

}  // namespace

FlightTest read_flight_test(const std::string& path, const ScriptParameters& stated, ScriptFaults& faults) {
    const IncludedScripts scripts = read_included_scripts(path, stated, faults);
    return FlightTestReader(scripts, faults).read();
}

}  // namespace tedavis::host_sim
