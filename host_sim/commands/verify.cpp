#include "host_sim/commands/verify.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/built_inputs.hpp"
#include "host_sim/commands/verify_board.hpp"
#include "host_sim/flight_test/flight_test_report.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/name_choices.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTestsFolder = "flight_tests";

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

/// "loss_of_roll" of "…/loss_of_roll.toml"; a second one of a name gets a number.
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
        std::error_code error;
        for (const char* const suffix : {".png", ".json"}) fs::remove(path + suffix, error);  // of an earlier run
        if (one.result.record.empty()) continue;
        write_file_atomically(path + ".json", one.result.record + "\n");
        one.record = path + ".json";
        if (one.result.picture.empty()) continue;
        write_file_atomically(path + ".png", one.result.picture);
        one.picture = path + ".png";
    }
}

/// Several scripts may share a command line: a parameter must be one of any of them.
bool has_unknown_parameter(const std::vector<FlightTest>& tests, const ScriptParameters& parameters, Console& console) {
    std::set<std::string> known;
    for (const FlightTest& test : tests) known.insert(test.parameters.begin(), test.parameters.end());
    bool has_unknown = false;
    for (const auto& [name, value] : parameters) {
        if (known.count(name) != 0) continue;
        has_unknown = true;
        console.note("tedavis: --set " + name + ": no script has such a parameter; there are: " + name_choices(known));
    }
    return has_unknown;
}

std::vector<FlightTest> read_tests(const VerifyOptions& options, const ScriptDefaults& defaults, Console& console,
                                   bool& is_faulty) {
    const ScriptParameters parameters = stated_parameters(options.parameters);
    std::vector<FlightTest> tests;
    ScriptFaults faults;
    for (const std::string& path : script_paths(options.scripts))
        tests.push_back(read_flight_test(path, parameters, faults, defaults));
    for (const std::string& sentence : faults.sentences()) console.note("tedavis: " + sentence);
    is_faulty = !faults.empty() || has_unknown_parameter(tests, parameters, console);
    return tests;
}

/// A line each, with the place of the input unless they say a place.
std::string with_place(const FlightTest& test, const std::string& sentences) {
    const bool has_place = sentences.compare(0, test.path.size() + 1, test.path + ":") == 0;
    return has_place ? sentences : test.path + ":" + std::to_string(test.input_line) + ": " + sentences;
}

/// Tests whose input cannot be played are told in `faults`, and the others are flown.
std::vector<FlownTest> fly_tests(std::vector<FlightTest>& tests, bool draws_failures, const std::string& folder,
                                 const InterruptGuard& interrupt, Console& console, std::vector<std::string>& faults) {
    BuiltInputs inputs(folder, console);
    TestDisplay display;
    std::vector<FlownTest> flown;
    const FlyTestSettings settings{folder, draws_failures, [&] { return interrupt.requested(); }};
    for (FlightTest& test : tests) {
        try {
            inputs.resolve_to_fly(test);
            FlightTestResult result = fly_flight_test(test, display, settings);
            flown.push_back({std::move(test), std::move(result), ""});
        } catch (const UserError& error) {
            faults.push_back(with_place(test, error.what()));
        }
        console.progress("flight tests", flown.size(), tests.size());
    }
    console.progress_done();
    return flown;
}

/// A test that was not flown to its end comes before one that does not hold: nobody knows what it would have shown. The same is
/// so where nothing at all was judged.
int exit_code_of(const std::vector<FlownTest>& tests, bool is_strict) {
    bool holds = true;
    for (const FlownTest& one : tests) {
        if (!one.fault.empty()) return kFaultyInputExitCode;
        holds = holds && one.holds().value_or(true) && !(is_strict && (one.result.not_judged() > 0 || !one.left_out.empty()));
    }
    if (judged_tests(tests) == 0) return kFaultyInputExitCode;
    return holds ? 0 : kCheckFailedExitCode;
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

int run_verify(const VerifyOptions& options, Console& console) {
    const std::optional<BoardFile> board =
        stated_board(options.target, options.board, options.interface_name + options.panel_lines);
    bool is_faulty = false;
    std::vector<FlightTest> tests = read_tests(options, board ? script_defaults(*board) : ScriptDefaults(), console, is_faulty);
    if (is_faulty) return kFaultyInputExitCode;
    const InterruptGuard interrupt;
    const TemporaryFolder work;
    std::optional<NewFolder> folder;
    if (!options.output.empty()) folder.emplace(options.output);
    std::optional<AtomicFile> junit;
    if (!options.junit.empty()) junit.emplace(options.junit);
    std::vector<std::string> faults;
    std::vector<FlownTest> flown =
        board ? fly_tests_on_board(tests, {options, *board, work.path(), [&] { return interrupt.requested(); }}, console)
              : fly_tests(tests, !options.output.empty(), work.path(), interrupt, console, faults);
    for (const std::string& sentence : faults) console.note("tedavis: " + sentence);
    if (!faults.empty()) return kFaultyInputExitCode;
    write_failures(flown, options.output);
    if (junit) junit->stream() << flight_tests_junit(flown);
    if (junit) junit->commit();
    if (folder) folder->keep();
    console.result(flight_tests_text(flown), json_text(flight_tests_json(flown)));
    return exit_code_of(flown, options.strict);
}

}  // namespace tedavis::host_sim
