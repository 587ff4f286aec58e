#include "host_sim/commands/verify.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/flight_test/flight_test_report.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTestsFolder = "flight_tests";

std::vector<std::string> script_paths(const std::vector<std::string>& named) {
    std::vector<std::string> paths;
    const std::vector<std::string> shipped = {shipped_root() + "/configs/" + kTestsFolder};
    for (const std::string& name : named.empty() ? shipped : named) {
        std::error_code error;
        if (!fs::is_directory(name, error)) {
            paths.push_back(resolve_config(name, kTestsFolder));
            continue;
        }
        const std::vector<std::string> inside = scripts_of_folder(name);
        if (inside.empty()) throw UserError(name + ": no script lies in this folder; name a folder with flight tests (*.toml)");
        paths.insert(paths.end(), inside.begin(), inside.end());
    }
    return paths;
}

ScriptParameters stated_parameters(const std::vector<std::string>& words) {
    ScriptParameters parameters;
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UserError("--set " + word + ": no name=value; say for example --set limit=90");
        parameters[word.substr(0, equals)] = stated_parameter(word.substr(equals + 1));
    }
    return parameters;
}

/// What tests name and a replay needs as files; each is built once.
class BuiltInputs {
public:
    BuiltInputs(const std::string& folder, Console& console) : folder_(folder), console_(console) {}

    void resolve(FlightTest& test) {
        test.picture.terrain = terrain(test.picture.terrain);
        if (!test.scenario.empty()) take_scenario(test);
        test.picture.scene = scene(test.picture.scene);
    }

private:
    static bool is_name(const std::string& text) { return !text.empty() && text.find_first_of("./") == std::string::npos; }

    template <class Build>
    std::string built(const std::string& name, Build build) {
        const auto [place, is_new] = built_.try_emplace(name);
        if (!is_new) return place->second;
        const std::string folder = folder_ + "/" + std::to_string(built_.size());
        make_folder(folder);
        place->second = build(folder);
        return place->second;
    }

    std::string terrain(const std::string& name) {
        if (!is_name(name)) return name;
        if (name != "jacksboro") throw UserError("terrain = \"" + name + "\": the shipped one is jacksboro; name it, or a .tdb");
        return built("terrain", [&](const std::string& folder) {
            return build_own_terrain({shipped_root() + kOwnRaster}, folder, console_);
        });
    }
    std::string scene(const std::string& name) {
        if (!is_name(name)) return name;
        return built("scene " + name, [&](const std::string& folder) { return build_own_scene(name, folder, console_); });
    }
    void take_scenario(FlightTest& test) {
        const std::string database = built("scenario " + test.scenario, [&](const std::string& folder) {
            return build_own_scenario(test.scenario, folder, console_);
        });
        const std::string folder = fs::path(database).parent_path().string();
        test.log = folder + "/flight.log";
        test.switch_log = folder + "/flight.switches";
        if (test.picture.scene.empty()) test.picture.scene = database;
    }

    std::string folder_;
    Console& console_;
    std::map<std::string, std::string> built_;
};

/// "GROUND" of "…/GROUND.toml"; a second one of a name gets a number.
std::string picture_stem(const std::string& path, std::set<std::string>& taken) {
    const std::string stem = fs::path(path).stem().string();
    std::string free = stem;
    for (int n = 2; !taken.insert(free).second; ++n) free = stem + "-" + std::to_string(n);
    return free;
}

/// The first failing instant, in the folder of the options.
void write_failures(std::vector<FlownTest>& tests, const std::string& output) {
    if (output.empty()) return;
    std::set<std::string> taken;
    for (FlownTest& one : tests) {
        const std::string path = output + "/" + picture_stem(one.test.path, taken);
        if (one.result.picture.empty()) continue;
        write_file_atomically(path + ".png", one.result.picture);
        write_file_atomically(path + ".json", one.result.record + "\n");
        one.picture = path + ".png";
    }
}

std::vector<FlightTest> read_tests(const VerifyOptions& options, Console& console, bool& is_faulty) {
    const ScriptParameters parameters = stated_parameters(options.parameters);
    std::vector<FlightTest> tests;
    ScriptFaults faults;
    for (const std::string& path : script_paths(options.scripts)) tests.push_back(read_flight_test(path, parameters, faults));
    for (const std::string& sentence : faults.sentences()) console.note("tedavis: " + sentence);
    is_faulty = !faults.empty();
    return tests;
}

/// What builds terrain and scenes speaks of its own files when it is interrupted.
void resolve(FlightTest& test, BuiltInputs& inputs) {
    try {
        inputs.resolve(test);
    } catch (const Interrupted&) {
        throw Interrupted("interrupted; a flight test that was not flown to its end has not passed");
    }
}

std::vector<FlownTest> fly_tests(std::vector<FlightTest>& tests, bool draws_failures, const std::string& folder,
                                 const InterruptGuard& interrupt, Console& console) {
    BuiltInputs inputs(folder, console);
    TestDisplay display;
    std::vector<FlownTest> flown;
    const FlyTestSettings settings{folder, draws_failures, [&] { return interrupt.requested(); }};
    for (FlightTest& test : tests) {
        resolve(test, inputs);
        FlightTestResult result = fly_flight_test(test, display, settings);
        flown.push_back({std::move(test), std::move(result), ""});
        console.progress("flight tests", flown.size(), tests.size());
    }
    console.progress_done();
    return flown;
}

}  // namespace

std::vector<std::string> scripts_of_folder(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ".toml") paths.push_back(entry.path().lexically_normal().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

int run_verify(const VerifyOptions& options, Console& console) {
    bool is_faulty = false;
    std::vector<FlightTest> tests = read_tests(options, console, is_faulty);
    if (is_faulty) return kFaultyInputExitCode;
    const InterruptGuard interrupt;
    const TemporaryFolder work;
    std::optional<NewFolder> folder;
    if (!options.output.empty()) folder.emplace(options.output);
    std::vector<FlownTest> flown = fly_tests(tests, !options.output.empty(), work.path(), interrupt, console);
    write_failures(flown, options.output);
    if (!options.junit.empty()) write_file_atomically(options.junit, flight_tests_junit(flown));
    if (folder) folder->keep();
    const nlohmann::ordered_json json = flight_tests_json(flown);
    console.result(flight_tests_text(flown), json_text(json));
    return json["holds"].get<bool>() ? 0 : kCheckFailedExitCode;
}

}  // namespace tedavis::host_sim
