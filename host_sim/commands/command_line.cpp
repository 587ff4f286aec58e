#include "host_sim/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <new>
#include <optional>
#include <ostream>
#include <string>

#include "host_sim/commands/calibrate.hpp"
#include "host_sim/commands/check.hpp"
#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/diff.hpp"
#include "host_sim/commands/option_checks.hpp"
#include "host_sim/commands/option_texts.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/replay_config.hpp"
#include "host_sim/commands/scenario.hpp"
#include "host_sim/commands/scene.hpp"
#include "host_sim/commands/sheet.hpp"
#include "host_sim/commands/shot.hpp"
#include "host_sim/commands/terrain.hpp"
#include "host_sim/console.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/version.hpp"
#include "host_sim/window/window_keys.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kDone = 0, kWrongUsage = 2;

/// Everything that the options write to, and what to run once they are parsed.
struct CommandLine {
    ConvertOptions convert;
    ScenarioBuildOptions scenario;
    SceneBuildOptions scene_build;
    SceneInfoOptions scene_info;
    TerrainBuildOptions terrain_build;
    TerrainCheckOptions terrain_check;
    TerrainInfoOptions terrain_info;
    TerrainFractalOptions terrain_fractal;
    ReplayOptions replay;
    ShotOptions shot;
    SheetOptions sheet;
    DiffOptions diff;
    CheckOptions check;
    CalibrateOptions calibrate;
    std::string replay_config;
    std::vector<CLI::Option*> replay_config_holds;  ///< what must not stand beside --config
    bool json = false;
    std::function<int(Console&)> run;
};

CLI::App* add_command(CLI::App& parent, CommandLine& line, const std::string& name, const std::string& purpose,
                      std::function<int(Console&)> run) {
    CLI::App* command = parent.add_subcommand(name, purpose);
    command->add_flag("--json", line.json, "machine-readable result on stdout");
    command->callback([&line, run = std::move(run)] { line.run = run; });
    return command;
}

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

/// What every command that draws has.
void add_surface_options(CLI::App* command, PictureOptions& picture) {
    static const std::map<std::string, GlChoice> kGl = {{"egl", GlChoice::egl}, {"osmesa", GlChoice::osmesa}};
    command->add_option("--terrain", picture.terrain, "terrain database (.tdb)");
    command->add_option("--scene", picture.scene, "spatial data: scene database (.sdb)");
    command->add_option("--device", picture.device, "device file or shipped name")->capture_default_str();
    command->add_option_function<std::string>(
        "--size", [&picture](const std::string& text) { picture.size = size_from(text); }, "WIDTHxHEIGHT; default: the device's");
    command
        ->add_option_function<std::string>(
            "--gl", [&picture](const std::string& word) { picture.gl = choice_from("--gl", word, kGl); }, "egl or osmesa")
        ->default_str("egl");
}

void add_picture_options(CLI::App* command, PictureOptions& picture) {
    add_surface_options(command, picture);
    command->add_option("--design", picture.design, "design file or shipped name")->capture_default_str();
    add_optional(command, "--tau", picture.tau_px, "terrain error in pixels; default: the design's")->check(above_zero());
    add_optional(command, "--deadline", picture.deadline_ms,
                 "milliseconds that a frame may take by the costs of --costs; default: none is held")
        ->check(above_zero());
    command->add_option("--costs", picture.costs, "what everything costs on this machine: a file that calibrate wrote");
    command->add_flag("--force-effects", picture.force_effects, "leave no effect out for being too small to be seen");
}

void add_convert(CLI::App& app, CommandLine& line) {
    ConvertOptions& o = line.convert;
    CLI::App* command =
        add_command(app, line, "convert", "recorded flight (IGC, GPX, ADS-B JSON, CSV) to a candump log of CANaerospace frames",
                    [&o](Console& console) { return run_convert(o, console); });
    command->add_option("FLIGHT", o.flight, "the recording; may be gzip-compressed")->required();
    command->add_option("-o", o.output, "the log to write")->required();
    command->add_option("--aircraft", o.aircraft, "identity or callsign where the file holds several");
    add_optional(
        command, "--qnh", o.qnh_hpa,
        "QNH in hPa: pressure altitudes become altitudes on that setting; no geometric heights without --assume-geometric");
    command->add_flag(
        "--assume-geometric", o.assume_geometric,
        "without GNSS heights, take barometric altitudes for heights above sea level: with --qnh those on that setting, "
        "else pressure altitudes as they are");
}

void add_scenario(CLI::App& app, CommandLine& line) {
    CLI::App* group = app.add_subcommand("scenario", "generated flights");
    group->require_subcommand(1);
    ScenarioBuildOptions& o = line.scenario;
    CLI::App* command =
        add_command(*group, line, "build", "scenario file to flight.log, flight.switches, scene.sdb and scenario.json",
                    [&o](Console& console) { return run_scenario_build(o, console); });
    command->add_option("SCENARIO", o.scenario, "scenario file or shipped name")->required();
    command->add_option("-o", o.output, "folder to write to")->required();
    add_optional(command, "--seed", o.seed, "replaces the file's seed")->check(from_zero());
}

void add_scene(CLI::App& app, CommandLine& line) {
    CLI::App* group = app.add_subcommand("scene", "scene databases: spatial data and their uncertainty");
    group->require_subcommand(1);
    SceneBuildOptions& b = line.scene_build;
    CLI::App* build = add_command(*group, line, "build", "scene file and its sources to a database",
                                  [&b](Console& console) { return run_scene_build(b, console); });
    build->add_option("SCENE", b.scene, "scene file or shipped name")->required();
    build->add_option("-o", b.output, "the database to write (.sdb)")->required();
    SceneInfoOptions& i = line.scene_info;
    CLI::App* info =
        add_command(*group, line, "info", "what a database holds", [&i](Console& console) { return run_scene_info(i, console); });
    info->add_option("DATABASE", i.database, "database (.sdb)")->required();
}

void add_raster_options(CLI::App* command, TerrainBuildOptions& o) {
    command->add_option("--crs", o.crs,
                        "coordinate system of the rasters where they do not state it, such as EPSG:4326; with a vertical part "
                        "(EPSG:4326+5773, EPSG:4979) also what heights are above");
    command->add_option("--extent", o.extent,
                        "W,S,E,N: outer edges of a raster that does not say where it lies, in units of --crs, else in degrees");
    command->add_option("--bounds", o.bounds, "W,S,E,N in degrees: leaves out what lies outside");
    command->add_option("--vertical-datum", o.vertical_datum, "egm96 or ellipsoid; default: what the rasters state, else egm96")
        ->check(CLI::IsMember({"egm96", "ellipsoid"}));
    command
        ->add_option("--encoding", o.encoding,
                     "how the colours of RGB rasters hold heights: terrain-rgb (Mapbox) or terrarium (Mapzen)")
        ->check(CLI::IsMember({"terrain-rgb", "terrarium"}));
    command->add_option("--drape", o.drape, "image to drape the terrain with: colour, grey or palette, georeferenced");
    command->add_option("--drape-crs", o.drape_crs, "coordinate system of that image where it does not state it");
    command->add_option(
        "--drape-extent", o.drape_extent,
        "W,S,E,N: outer edges of an image that does not say where it lies, in units of --drape-crs, else in degrees");
    add_optional(command, "--void", o.void_value, "the value that marks voids where the raster does not state it");
    add_optional(command, "--accuracy", o.accuracy_m,
                 "vertical accuracy of the source, LE90 in metres; a check without it believes the database")
        ->check(from_zero());
}

void add_terrain(CLI::App& app, CommandLine& line) {
    CLI::App* group = app.add_subcommand("terrain", "terrain databases");
    group->require_subcommand(1);
    TerrainBuildOptions& b = line.terrain_build;
    CLI::App* build = add_command(*group, line, "build", "rasters to a database with error proof",
                                  [&b](Console& console) { return run_terrain_build(b, console); });
    build->add_option("DEM", b.rasters, "any raster that GDAL reads")->required();
    build->add_option("-o", b.output, "the database to write (.tdb)")->required();
    add_raster_options(build, b);
    TerrainCheckOptions& c = line.terrain_check;
    CLI::App* check = add_command(*group, line, "check", "every chunk against the rasters again",
                                  [&c](Console& console) { return run_terrain_check(c, console); });
    check->add_option("DATABASE", c.database, "database (.tdb)")->required();
    check->add_option("DEM", c.build.rasters, "the rasters it was built from")->required();
    add_raster_options(check, c.build);
    TerrainInfoOptions& i = line.terrain_info;
    CLI::App* info = add_command(*group, line, "info", "what a database holds",
                                 [&i](Console& console) { return run_terrain_info(i, console); });
    info->add_option("DATABASE", i.database, "database (.tdb)")->required();
    TerrainFractalOptions& f = line.terrain_fractal;
    CLI::App* fractal = add_command(*group, line, "fractal", "generated terrain, a square of any size",
                                    [&f](Console& console) { return run_terrain_fractal(f, console); });
    fractal->add_option("--size", f.size, "posts a side")->check(from_zero())->capture_default_str();
    fractal->add_option("--seed", f.seed, "equal seeds give equal terrain")->check(from_zero())->capture_default_str();
    fractal->add_option("--type", f.numbers, "float32, or int16: whole metres in half the space")
        ->check(CLI::IsMember({"float32", "int16"}))
        ->capture_default_str();
    fractal->add_option("-o", f.output, "the raster to write (.tif)")->required();
}

void add_time(CLI::App* command, std::optional<base::Time>& time) {
    command->add_option_function<std::string>(
        "--time", [&time](const std::string& text) { time = time_from(text); },
        "UTC such as 2026-06-01T14:00:00Z, by which data are valid and have an age; default: data at their own first time");
}

void add_shot(CLI::App& app, CommandLine& line) {
    ShotOptions& o = line.shot;
    CLI::App* command =
        add_command(app, line, "shot", "one picture and its record", [&o](Console& console) { return run_shot(o, console); });
    command
        ->add_option_function<std::string>(
            "--pose", [&o](const std::string& text) { o.pose = pose_from(text); }, "lat,lon,alt_m,heading,pitch,roll")
        ->required();
    add_time(command, o.time);
    command->add_option_function<std::string>(
        "--phase", [&o](const std::string& text) { o.phase = phase_from(text); },
        "flight phase, as if a switch stated it; default: none is stated");
    command->add_option("-o", o.output, "the picture to write (.png)")->required();
    add_picture_options(command, o.picture);
}

void add_calibrate(CLI::App& app, CommandLine& line) {
    CalibrateOptions& o = line.calibrate;
    CLI::App* command = add_command(app, line, "calibrate", "what every effect costs on this machine, as a file for --costs",
                                    [&o](Console& console) { return run_calibrate(o, console); });
    command->add_option("-o", o.output, "the costs to write (.toml); beside it as .json what they were measured from")
        ->required();
    add_surface_options(command, o.picture);
    command->add_option("--design", o.picture.design, "its own effects are measured in it")->capture_default_str();
    command->add_option_function<std::string>(
        "--pose", [&o](const std::string& text) { o.pose = pose_from(text); },
        "lat,lon,alt_m,heading,pitch,roll; with --terrain");
    add_time(command, o.time);
    command->add_option("--rounds", o.rounds, "frames with and without each effect")
        ->check(CLI::Range(3, 1000))
        ->capture_default_str();
}

void add_sheet(CLI::App& app, CommandLine& line) {
    SheetOptions& o = line.sheet;
    CLI::App* command = add_command(app, line, "sheet", "contact sheet: one labelled picture a technique",
                                    [&o](Console& console) { return run_sheet(o, console); });
    command->add_option("SHEET", o.sheet, "sheet file or shipped name, such as terrain-styles")->required();
    command->add_option("-o", o.output, "folder to write to")->required();
    command->add_option_function<std::string>(
        "--pose", [&o](const std::string& text) { o.pose = pose_from(text); },
        "lat,lon,alt_m,heading,pitch,roll; default: the sheet's");
    add_time(command, o.time);
    add_surface_options(command, o.picture);
    command->get_option("--terrain")->description("terrain database (.tdb); default: built from the sheet's raster");
    command->get_option("--scene")->description("scene database (.sdb); default: built from the sheet's scene");
    command->get_option("--size")->description("WIDTHxHEIGHT of a picture; default: the sheet's");
}

/// What --config says, with what may stand beside it on the command line.
void use_replay_config(CommandLine& line) {
    if (line.replay_config.empty()) return;
    for (const CLI::Option* option : line.replay_config_holds)
        if (option->count() > 0)
            throw UserError("--config " + line.replay_config + ": this file says it already; leave out " + option->get_name());
    const ReplayOptions given = line.replay;
    line.replay = load_replay_config(line.replay_config);
    line.replay.output = given.output;
    line.replay.window = given.window;
    line.replay.tour = given.tour;
    line.replay.save_config = given.save_config;
}

int run_replay_line(CommandLine& line, Console& console) {
    use_replay_config(line);
    const std::string& from = line.replay_config.empty() ? std::string("replay") : line.replay_config;
    if (line.replay.log.empty()) throw UserError(from + ": no log named; give a candump log, or --config with a saved replay");
    return run_replay(line.replay, console);
}

void add_replay_instants(CLI::App* command, ReplayOptions& o) {
    add_optional(command, "--from", o.from_s, "earliest frame, in seconds since the log's first; default: 0");
    add_optional(command, "--to", o.to_s, "latest frame; not before --from, also when going backwards; default: the log's end");
    add_optional(command, "--step", o.step_s,
                 "seconds between frames; negative: backwards from --to down to --from; default: the device's rate");
    static const std::map<std::string, FrameOutput> kOutputs{
        {"png", FrameOutput::png}, {"hash", FrameOutput::hash}, {"none", FrameOutput::none}};
    command->add_option_function<std::string>(
        "--frames", [&o](const std::string& word) { o.frames = choice_from("--frames", word, kOutputs); },
        "png, hash or none; default: png, with --window hash");
}

void add_replay(CLI::App& app, CommandLine& line) {
    ReplayOptions& o = line.replay;
    CLI::App* command = add_command(app, line, "replay", "recorded bus through the core: frames, records and a report",
                                    [&line](Console& console) { return run_replay_line(line, console); });
    command->add_option("LOG", o.log, "candump log");
    command->add_option("--switches", o.switches, "switch log");
    command->add_option("--switch-config", o.switch_config, "file or shipped name")->capture_default_str();
    add_replay_instants(command, o);
    command->add_option("--bus", o.picture.bus, "bus file or shipped name: how the log's frames are read")->capture_default_str();
    add_picture_options(command, o.picture);
    line.replay_config_holds = command->get_options(
        [](const CLI::Option* option) { return !option->check_name("--help") && !option->check_name("--json"); });
    command->add_option("-o", o.output, "folder to write to")->required();
    command->add_option("--save-config", o.save_config,
                        "writes data, design and parameters of this replay to a file, after --window with its switches");
    CLI::Option* window = command->add_flag("--window", o.window, "in a window on the screen, with the keys below");
    command->add_option("--tour", o.tour, "path file (CSV) that the window's camera follows")->needs(window);
    command->add_option("--config", line.replay_config,
                        "a file that --save-config wrote; beside it only -o, --save-config, --window and --tour");
    command->footer(window_keys_help());
}

void add_comparisons(CLI::App& app, CommandLine& line) {
    DiffOptions& d = line.diff;
    CLI::App* diff = add_command(app, line, "diff", "the first frame in which two runs differ",
                                 [&d](Console& console) { return run_diff(d, console); });
    diff->add_option("RUN_A", d.run_a, "folder that replay wrote")->required();
    diff->add_option("RUN_B", d.run_b, "another one")->required();
    CheckOptions& c = line.check;
    CLI::App* check = add_command(app, line, "check", "validates configuration files, databases and logs",
                                  [&c](Console& console) { return run_check(c, console); });
    check->add_option("FILE", c.files, "any file that the programs read")->required();
}

/// Messages may span lines and quote what a broken file holds; the contract is one line that a terminal can show.
std::string one_sentence(std::string text) {
    constexpr std::size_t kLongest = 1000;
    for (char& c : text) {
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
        if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
    }
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

bool has_command(const CLI::App& app, const std::string& name) {
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    return std::any_of(commands.begin(), commands.end(), [&](const CLI::App* command) { return command->check_name(name); });
}

int parse_and_run(int argc, const char* const* argv, std::ostream& results, std::ostream& notes, bool live) {
    CommandLine line;
    CLI::App app("tedavis: recorded flights through a synthetic-vision display. Not certified for use in flight.", "tedavis");
    app.set_version_flag("--version", std::string("tedavis ") + version());
    app.require_subcommand(1);
    add_convert(app, line);
    add_scenario(app, line);
    add_scene(app, line);
    add_terrain(app, line);
    add_shot(app, line);
    add_sheet(app, line);
    add_calibrate(app, line);
    add_replay(app, line);
    add_comparisons(app, line);
    if (argc > 1 && argv[1][0] != '-' && !has_command(app, argv[1])) {
        throw UserError(std::string(argv[1]) + ": no such command; tedavis --help lists them");
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& request) {
        app.exit(request, results, notes);  // --help, --version
        return kDone;
    } catch (const CLI::ParseError& error) {
        notes << "tedavis: " << one_sentence(error.what()) << "; see tedavis --help\n";
        return kWrongUsage;
    }
    Console console(results, notes, line.json, live);
    return line.run(console);
}

}  // namespace

int run_command_line(int argc, const char* const* argv, std::ostream& results, std::ostream& notes, bool live) {
    try {
        return parse_and_run(argc, argv, results, notes, live);
    } catch (const UserError& error) {
        notes << "tedavis: " << one_sentence(error.what()) << '\n';
    } catch (const Interrupted& interrupted) {
        notes << "tedavis: " << interrupted.what() << '\n';
        return kInterruptedExitCode;
    } catch (const std::bad_alloc&) {
        notes << "tedavis: not enough memory for this input; split it\n";
    } catch (const std::exception& error) {
        notes << "tedavis: " << error.what() << "; please report this\n";
    }
    return kWrongUsage;
}

}  // namespace tedavis::host_sim
