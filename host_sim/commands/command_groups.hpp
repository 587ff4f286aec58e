/// The commands and their options, in groups; command_line.cpp puts them together.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/commands/accuracy.hpp"
#include "host_sim/commands/bus_encode.hpp"
#include "host_sim/commands/calibrate.hpp"
#include "host_sim/commands/check.hpp"
#include "host_sim/commands/compare.hpp"
#include "host_sim/commands/contract.hpp"
#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/device.hpp"
#include "host_sim/commands/diff.hpp"
#include "host_sim/commands/evaluate.hpp"
#include "host_sim/commands/fly.hpp"
#include "host_sim/commands/kept_terrains.hpp"
#include "host_sim/commands/pack.hpp"
#include "host_sim/commands/record.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/scenario.hpp"
#include "host_sim/commands/scene.hpp"
#include "host_sim/commands/scene_look.hpp"
#include "host_sim/commands/shaders.hpp"
#include "host_sim/commands/sheet.hpp"
#include "host_sim/commands/shot.hpp"
#include "host_sim/commands/sweep.hpp"
#include "host_sim/commands/terrain.hpp"
#include "host_sim/commands/trace.hpp"
#include "host_sim/commands/verify.hpp"
#include "host_sim/console.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

/// The values of all options, and the command to run after parsing.
struct CommandLine {
    ConvertOptions convert;
    ScenarioBuildOptions scenario;
    SceneBuildOptions scene_build;
    SceneInfoOptions scene_info;
    SceneLookOptions scene_look;
    TerrainBuildOptions terrain_build;
    TerrainCheckOptions terrain_check;
    TerrainInfoOptions terrain_info;
    TerrainFractalOptions terrain_fractal;
    TerrainCacheOptions terrain_cache;
    ReplayOptions replay;
    PackOptions pack;
    FlyOptions fly;
    ShotOptions shot;
    TraceOptions trace;
    SheetOptions sheet;
    SweepOptions sweep;
    DiffOptions diff;
    CompareOptions compare;
    CheckOptions check;
    EvaluateOptions evaluate;
    ContractOptions contract;
    VerifyOptions verify;
    RecordOptions record;
    BusEncodeOptions bus_encode;
    CalibrateOptions calibrate;
    DevicePlanOptions device_plan;
    AccuracyOptions accuracy;
    ShadersOptions shaders;
    std::string replay_config;
    std::string pack_key = platform::kInstalledPackKey;
    CLI::App* replay_command = nullptr;
    std::vector<CLI::Option*> replay_config_holds;  ///< options that must not be combined with --config
    bool json = false;
    std::function<int(Console&)> run;
};

/// Adds a command with --json; `run` is executed after parsing.
[[nodiscard]] CLI::App* add_command(CLI::App& parent, CommandLine& line, const std::string& name, const std::string& purpose,
                                    std::function<int(Console&)> run);

/// The same for a command that Ctrl-C ends early (InterruptGuard), also while it loads its files. All long work of the command,
/// and its output, must query the guard.
[[nodiscard]] CLI::App* add_long_command(CLI::App& parent, CommandLine& line, const std::string& name, const std::string& purpose,
                                         std::function<int(Console&)> run);

/// --strict: warnings end the command with kCheckFailedExitCode.
void add_strict(CLI::App* command, bool& strict);
/// --class; `otherwise` is the help's text on the default.
void add_class(CLI::App* command, std::optional<flight::AircraftClass>& aircraft, const std::string& otherwise);

template <class T>
CLI::Option* add_optional(CLI::App* command, const std::string& name, std::optional<T>& target, const std::string& help) {
    return command->add_option_function<T>(
        name, [&target](const T& value) { target = value; }, help);
}

template <class Choice>
Choice choice_from(const std::string& option, const std::string& word, const std::map<std::string, Choice>& choices) {
    const auto found = choices.find(word);
    if (found != choices.end()) return found->second;
    std::string names;
    for (const auto& [name, choice] : choices) names += (names.empty() ? "" : ", ") + name;
    throw UserError(option + " " + word + ": unknown; choose one of " + names);
}

/// convert, scenario, scene, terrain, pack: commands that make files for the display.
void add_builders(CLI::App& app, CommandLine& line);
/// shot, trace, sheet, sweep, device, calibrate, accuracy, shaders, replay: commands that draw.
void add_displays(CLI::App& app, CommandLine& line);
/// Options of a raster that becomes a terrain database.
void add_raster_options(CLI::App* command, TerrainBuildOptions& options);
/// Options that choose a recording's aircraft and the meaning of its altitudes.
void add_flight_options(CLI::App* command, ConvertOptions& options);
/// fly, which combines commands of all groups.
void add_fly(CLI::App& app, CommandLine& line);
/// verify, record and bus: commands for the tests of integrators.
void add_tests(CLI::App& app, CommandLine& line);
/// accuracy, which add_displays() adds.
void add_accuracy(CLI::App& app, CommandLine& line);
/// replay, which add_displays() adds, too.
void add_replay(CLI::App& app, CommandLine& line);

}  // namespace tedavis::host_sim
