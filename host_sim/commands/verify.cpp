#include "host_sim/commands/verify.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/built_inputs.hpp"
#include "host_sim/commands/verify_board.hpp"
#include "host_sim/flight_test/flight_test_report.hpp"
#include "host_sim/flight_test/input_logs.hpp"
#include "host_sim/flight_test/nearest_names.hpp"
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

/// Where the picture and the record of each script go, without their suffixes.
std::vector<std::string> picture_paths(const std::vector<std::string>& scripts, const std::string& output) {
    std::vector<std::string> paths;
    std::set<std::string> taken;
    for (const std::string& script : scripts) paths.push_back(output + "/" + picture_stem(script, taken));
    return paths;
}

/// Whoever reads them after a run that ends early must not take them for its results.
void remove_earlier_pictures(const std::vector<std::string>& scripts, const std::string& output) {
    if (output.empty()) return;
    std::error_code error;
    for (const std::string& path : picture_paths(scripts, output))
        for (const char* const suffix : {".png", ".json"}) fs::remove(path + suffix, error);
}

/// The first failing instant, in the folder of the options.
void write_failures(std::vector<FlownTest>& tests, const std::vector<std::string>& scripts, const std::string& output) {
    if (output.empty()) return;
    const std::vector<std::string> paths = picture_paths(scripts, output);
    for (FlownTest& one : tests) {
        if (one.result.record.empty()) continue;
        const std::string& path =
            paths[static_cast<std::size_t>(std::find(scripts.begin(), scripts.end(), one.test.path) - scripts.begin())];
        write_file_atomically(path + ".json", one.result.record + "\n");
        one.record = path + ".json";
        if (one.result.picture.empty()) continue;
        write_file_atomically(path + ".png", one.result.picture);
        one.picture = path + ".png";
    }
}

/// Several scripts may share a command line: a parameter must be one of any of them. A sentence for each that is not.
std::vector<std::string> unknown_parameters(const std::vector<FlownTest>& tests, const ScriptParameters& parameters) {
    std::set<std::string> known;
    for (const FlownTest& one : tests) known.insert(one.test.parameters.begin(), one.test.parameters.end());
    std::vector<std::string> sentences;
    for (const auto& [name, value] : parameters)
        if (known.count(name) == 0)
            sentences.push_back("--set " + name + ": no script has such a parameter; there are: " + name_choices(known));
    return sentences;
}

std::string lines_of(const std::vector<std::string>& sentences) {
    std::string lines;
    for (const std::string& sentence : sentences) lines += (lines.empty() ? "" : "\n") + sentence;
    return lines;
}

/// A line each, once: an included file is read with each script that includes it.
void tell_faults(const std::vector<FlownTest>& tests, Console& console) {
    std::set<std::string> told;
    for (const FlownTest& one : tests) {
        std::istringstream lines(one.fault);
        for (std::string line; std::getline(lines, line);)
            if (told.insert(line).second) console.note("tedavis: " + line);
    }
}

/// Not flown yet; a script that is wrong has a fault.
std::vector<FlownTest> read_tests(const VerifyOptions& options, const std::vector<std::string>& scripts,
                                  const ScriptDefaults& defaults) {
    const ScriptParameters parameters = stated_parameters(options.parameters);
    std::vector<FlownTest> tests;
    for (const std::string& path : scripts) {
        ScriptFaults faults;
        FlightTest test = read_flight_test(path, parameters, faults, defaults);
        test.path = path;
        if (test.title.empty()) test.title = fs::path(path).stem().string();
        tests.push_back({std::move(test), {}, "", "", "", lines_of(faults.sentences())});
    }
    if (const std::string lines = lines_of(unknown_parameters(tests, parameters)); !lines.empty())
        for (FlownTest& one : tests) one.fault += (one.fault.empty() ? "" : "\n") + lines;
    for (FlownTest& one : tests) one.is_wrong = !one.fault.empty();
    return tests;
}

bool has_fault(const std::vector<FlownTest>& tests) {
    return std::any_of(tests.begin(), tests.end(), [](const FlownTest& one) { return !one.fault.empty(); });
}

bool is_interrupted(const std::vector<FlownTest>& tests) {
    return std::any_of(tests.begin(), tests.end(), [](const FlownTest& one) { return one.fault == kTestInterrupted; });
}

/// A line each, with the place of the input unless they say a place.
std::string with_place(const FlightTest& test, const std::string& sentences) {
    const bool has_place = sentences.compare(0, test.path.size() + 1, test.path + ":") == 0;
    return has_place ? sentences : test.path + ":" + std::to_string(test.input_line) + ": " + sentences;
}

/// A test whose input cannot be played has a fault, and the others are flown, unless Ctrl-C ends them: then they have that fault.
void fly_tests(std::vector<FlownTest>& tests, bool draws_failures, const std::string& folder, const InterruptGuard& interrupt,
               Console& console) {
    BuiltInputs inputs(folder, console);
    TestDisplay display;
    const FlyTestSettings settings{folder, draws_failures, [&] { return interrupt.requested(); }};
    std::size_t flown = 0;
    for (FlownTest& one : tests) {
        if (is_interrupted(tests)) {
            one.fault = kTestInterrupted;
            continue;
        }
        try {
            inputs.resolve_to_fly(one.test);
            one.result = fly_flight_test(one.test, display, settings);
        } catch (const UserError& error) {
            one.fault = with_place(one.test, error.what());
            one.is_wrong = true;
        } catch (const Interrupted&) {
            one.fault = kTestInterrupted;
        }
        console.progress("flight tests", ++flown, tests.size());
    }
    console.progress_done();
}

std::vector<FlownTest> fly_all_on_board(std::vector<FlownTest>& read, const BoardTests& settings, Console& console) {
    std::vector<FlightTest> tests;
    for (FlownTest& one : read) tests.push_back(std::move(one.test));
    return fly_tests_on_board(tests, settings, console);
}

/// Nothing is flown where a script is wrong; whoever reads results finds the fault there.
int refuse_tests(std::vector<FlownTest>& tests, const VerifyOptions& options, Console& console) {
    tell_faults(tests, console);
    for (FlownTest& one : tests)
        if (one.fault.empty()) one.left_out = "was not flown, as another script is wrong";
    if (!options.junit.empty()) write_file_atomically(options.junit, flight_tests_junit(tests));
    if (console.json()) console.result("", json_text(flight_tests_json(tests)));
    return kFaultyInputExitCode;
}

/// Ctrl-C comes first. A test that was not flown to its end comes before one that does not hold: nobody knows what it would have
/// shown. The same is so where nothing at all was judged.
int exit_code_of(const std::vector<FlownTest>& tests, bool is_strict) {
    bool holds = true;
    if (is_interrupted(tests)) return kInterruptedExitCode;
    for (const FlownTest& one : tests) {
        if (!one.fault.empty()) return kFaultyInputExitCode;
        holds = holds && one.holds().value_or(true) && !(is_strict && (one.result.not_judged() > 0 || !one.left_out.empty()));
    }
    if (judged_tests(tests) == 0) return kFaultyInputExitCode;
    return holds ? 0 : kCheckFailedExitCode;
}

/// A file, or a shipped script by its name.
std::string script_path(const std::string& name, const std::string& shipped_folder) {
    try {
        return resolve_config(name, kTestsFolder);
    } catch (const UserError&) {
        std::vector<std::string> shipped;
        for (const std::string& path : scripts_of_folder(shipped_folder)) shipped.push_back(fs::path(path).stem().string());
        throw UserError(name + ": there is no such file and no shipped script of this name; say " +
                        nearest_names(fs::path(name).stem().string(), shipped) + ", or name a file; " + shipped_folder +
                        " has all shipped ones");
    }
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
    const std::string shipped = shipped_root() + "/configs/" + kTestsFolder;
    for (const std::string& name : named.empty() ? std::vector<std::string>{shipped} : named) {
        std::error_code error;
        if (!fs::is_directory(name, error)) {
            paths.push_back(script_path(name, shipped));
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
    require_other_file(options.junit, options.scripts);
    std::error_code error;
    if (fs::is_regular_file(options.junit, error)) fs::remove(options.junit, error);  // of an earlier run, as are the pictures
    const std::vector<std::string> scripts = script_paths(options.scripts);
    remove_earlier_pictures(scripts, options.output);
    std::vector<FlownTest> tests = read_tests(options, scripts, board ? script_defaults(*board) : ScriptDefaults());
    if (has_fault(tests)) return refuse_tests(tests, options, console);
    const InterruptGuard interrupt;
    const TemporaryFolder work;
    std::optional<NewFolder> folder;
    if (!options.output.empty()) folder.emplace(options.output);
    std::optional<AtomicFile> junit;
    if (!options.junit.empty()) junit.emplace(options.junit);
    if (board)
        tests = fly_all_on_board(tests, {options, *board, work.path(), [&] { return interrupt.requested(); }}, console);
    else
        fly_tests(tests, !options.output.empty(), work.path(), interrupt, console);
    write_failures(tests, scripts, options.output);
    if (junit) junit->stream() << flight_tests_junit(tests);
    if (junit) junit->commit();
    if (folder) folder->keep();
    if (console.json() || is_interrupted(tests)) tell_faults(tests, console);
    console.result(flight_tests_text(tests), json_text(flight_tests_json(tests)));
    return exit_code_of(tests, options.strict);
}

}  // namespace tedavis::host_sim
