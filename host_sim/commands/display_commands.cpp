#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/display_sheet.hpp"
#include "host_sim/commands/gallery_sheet.hpp"
#include "host_sim/commands/option_checks.hpp"
#include "host_sim/commands/option_texts.hpp"
#include "host_sim/commands/readme_sheet.hpp"
#include "host_sim/commands/trace_sheet.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/window/window_keys.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kLayersText =
    "beside each picture X.layers.png: 0 terrain, 1 data, 2 uncertainty, 3 labels, 4 symbology, by which pixel is whose";

/// What every command that draws has.
void add_surface_options(CLI::App* command, PictureOptions& picture) {
    static const std::map<std::string, GlChoice> kGl = {{"egl", GlChoice::egl}, {"osmesa", GlChoice::osmesa}};
    command->add_option("--terrain", picture.terrain, "terrain database (.tdb)");
    command->add_option("--scene", picture.scene, "spatial data: scene database (.sdb)");
    command->add_option("--device", picture.device, "device file or shipped name")->capture_default_str();
    command->add_option(
        "--aircraft", picture.aircraft,
        "aircraft file or shipped name: speeds for the airspeed tape and the pilot's eye point; default: none is known");
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
    command->add_option("--palette", picture.palette,
                        "palette file of the symbology or shipped name: its colors by day and by night; default: standard");
    static const std::map<std::string, design::SymbologyLight> kLight = {{"day", design::SymbologyLight::day},
                                                                         {"night", design::SymbologyLight::night}};
    command
        ->add_option_function<std::string>(
            "--light", [&picture](const std::string& word) { picture.light = choice_from("--light", word, kLight); },
            "day or night: colors of the symbology; terrain, sky and data keep theirs")
        ->default_str("day");
    add_optional(command, "--tau", picture.tau_px, "terrain error in pixels; default: the design's")->check(above_zero());
    command->add_option_function<std::string>(
        "--weights", [&picture](const std::string& text) { picture.weights = weights_from(text); },
        "of aspects, 0 to 1, such as terrain=0.3,data=1; default: the design's");
    command
        ->add_option("--focus", picture.foci,
                     "a focus before the design's: the keys of [[focus]] within one line of TOML, such as "
                     "'shape = \"circle\", at = \"place\", place = \"DAVOS\", terrain.brightness = 0.5'; may be repeated")
        ->allow_extra_args(false);
    add_optional(command, "--deadline", picture.deadline_ms,
                 "milliseconds that a frame may take by the costs of --costs; default: none is held")
        ->check(above_zero());
    command->add_option(
        "--costs", picture.costs,
        "what everything costs on this machine, and the quality levels to choose from: a file that calibrate wrote");
    static const std::map<std::string, design::SaliencyView> kSaliency = {{"heat", design::SaliencyView::heat},
                                                                          {"map", design::SaliencyView::map}};
    command->add_option_function<std::string>(
        "--saliency", [&picture](const std::string& word) { picture.saliency = choice_from("--saliency", word, kSaliency); },
        "what draws the eye in each picture: heat (over it) or map (alone); default: as the design says");
    static const std::map<std::string, design::ClutterView> kClutter = {{"edges", design::ClutterView::edges},
                                                                        {"regions", design::ClutterView::regions}};
    command->add_option_function<std::string>(
        "--clutter", [&picture](const std::string& word) { picture.clutter = choice_from("--clutter", word, kClutter); },
        "edges of each picture (alone), or regions (how dense they are, over it); default: as the design says");
    command->add_flag("--force-effects", picture.force_effects, "leave no effect out for being too small to be seen");
}

void add_legend(CLI::App* command, PictureOptions& picture) {
    static const std::map<std::string, flight::LegendShow> kLegends = {
        {"none", flight::LegendShow::none}, {"key", flight::LegendShow::key}, {"whole", flight::LegendShow::whole}};
    command
        ->add_option_function<std::string>(
            "--legend", [&picture](const std::string& word) { picture.legend = choice_from("--legend", word, kLegends); },
            "none, key (a small key of the scales that are shown) or whole; a switch or the bus may ask for another")
        ->default_str("key");
}

void add_accuracy_shown(CLI::App* command, AccuracyShown& shown) {
    command->add_flag("--show-accuracy", shown.figures,
                      "writes over each picture its requested and its proven terrain error and its quality level");
    command->add_flag("--error-map", shown.error_map,
                      "colors the ground by its measured error on the screen, dark blue at 0 to yellow at the requested error");
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
    command->add_flag("--layers", o.layers, kLayersText);
    add_strict(command, o.strict);
    add_picture_options(command, o.picture);
    add_legend(command, o.picture);
    add_accuracy_shown(command, o.accuracy);
}

/// What is traced, and from where.
void add_traced_ground(CLI::App* command, TraceOptions& o) {
    command->add_option("--terrain", o.terrain.database, "terrain database (.tdb); default: built from the shipped raster");
    command->add_option("--heights", o.terrain.heights, "raster of heights, which is built into a database first");
    command->add_option("--scene", o.scene,
                        "scene database (.sdb): one of its quantities colors the ground, the fainter the less sure");
    command->add_option("--data", o.data, "which: a layer on a grid, or layer.attribute; default: the scene's first")
        ->needs("--scene");
    command->add_option_function<std::string>(
        "--pose", [&o](const std::string& text) { o.pose = pose_from(text); },
        "lat,lon,alt_m,heading,pitch,roll; default: over the south of the terrain, northwards");
}

/// By which settings: a preset, or chosen by region.
void add_trace_settings(CLI::App* command, TraceOptions& o) {
    static const std::map<std::string, TracePreset> kPresets = {
        {"time", TracePreset::time}, {"quality", TracePreset::quality}, {"memory", TracePreset::memory}};
    command
        ->add_option_function<std::string>(
            "--preset", [&o](const std::string& word) { o.preset = choice_from("--preset", word, kPresets); },
            "time, quality or memory: what the picture spares, or is best at")
        ->default_str("time");
    CLI::Option* search =
        command
            ->add_option_function<std::string>(
                "--search", [&o](const std::string& text) { o.search = search_from(text); },
                "NAME[:steps[:halvings]], how rays find the ground: exact; or, to see what it costs and what it misses, cells "
                "(steps in each cell), ray (over the whole ray) or cones (over bilinear ground)")
            ->default_str("exact");
    const auto chosen = [&o]() -> ChoicePlan& { return o.choice.has_value() ? *o.choice : o.choice.emplace(); };
    command
        ->add_option_function<double>(
            "--deadline", [chosen](double ms) { chosen().deadline_ms = ms; },
            "ms for a picture: settings are chosen region by region, near and lit ones first, from what they cost here")
        ->check(above_zero())
        ->excludes("--preset")
        ->excludes(search);
    command
        ->add_option_function<double>(
            "--most-error", [chosen](double error) { chosen().most_error = error; },
            "how far the picture may be from the best, root mean square of light 0..1: the cheapest such settings are chosen")
        ->check(above_zero())
        ->excludes("--preset")
        ->excludes(search);
}

void add_trace(CLI::App& app, CommandLine& line) {
    TraceOptions& o = line.trace;
    CLI::App* command = add_command(app, line, "trace", "one picture of the terrain by the ray tracer, and what it took",
                                    [&o](Console& console) { return run_trace(o, console); });
    add_traced_ground(command, o);
    add_trace_settings(command, o);
    command
        ->add_option_function<std::string>(
            "--size",
            [&o](const std::string& text) {
                const PictureSize size = size_from(text);
                o.plan.width = size.width;
                o.plan.height = size.height;
            },
            "WIDTHxHEIGHT")
        ->default_str("1024x768");
    command->add_option("--field-of-view", o.plan.field_of_view_deg, "degrees over the width")
        ->check(CLI::Range(1.0, 150.0))
        ->capture_default_str();
    command->add_option_function<std::string>(
        "--time", [&o](const std::string& text) { o.plan.time = time_from(text); },
        "UTC such as 2026-06-01T14:00:00Z, by which the sun stands and data are valid; default: light from the north-west, data "
        "of their own first time");
    command
        ->add_option(
            "--memory", o.memory_mb,
            "MB that heights and their bounds may take, without pixels and rays: where all heights take more, they are read in "
            "chunks as rays need them, which --preset time allows; default: no limit")
        ->check(above_zero());
    command->add_option("--workers", o.workers, "threads; default: as many as there are processors")->check(CLI::Range(1u, 64u));
    command->add_option("--block-size", o.plan.block_words, "words in a block of the token stream: 64 to 4096, a power of two")
        ->capture_default_str();
    command->add_flag("--direct", o.plan.is_direct, "call the stages directly, without the token stream");
    command->add_option("--rounds", o.plan.rounds, "how often it is drawn, for the median of its times")
        ->check(CLI::Range(1u, 1000u))
        ->capture_default_str();
    command->add_option("-o", o.output, "the picture to write (.png); X.json beside it says what it took")->required();
}

void add_calibrate(CLI::App& app, CommandLine& line) {
    CalibrateOptions& o = line.calibrate;
    CLI::App* command =
        add_command(app, line, "calibrate", "what every effect and quality level costs on this machine, as a file for --costs",
                    [&o](Console& console) { return run_calibrate(o, console); });
    command->add_option("-o", o.output, "the costs to write (.toml); beside it as .json what they were measured from")
        ->required();
    add_surface_options(command, o.picture);
    command->add_option("--design", o.picture.design, "its own effects are measured in it")->capture_default_str();
    command->add_option_function<std::string>(
        "--pose", [&o](const std::string& text) { o.pose = pose_from(text); },
        "lat,lon,alt_m,heading,pitch,roll; with --terrain");
    add_time(command, o.time);
    command->add_option("--rounds", o.rounds, "frames with and without each effect; a third as many of each quality level")
        ->check(CLI::Range(3, 1000))
        ->capture_default_str();
}

void add_shaders(CLI::App& app, CommandLine& line) {
    ShadersOptions& o = line.shaders;
    o.picture.device = "sc2";
    CLI::App* command = add_command(app, line, "shaders", "a design's programs as binaries, for a device without a compiler",
                                    [&o](Console& console) { return run_shaders(o, console); });
    command->add_option("-o", o.output, "folder to write to; a board file names it as its programs")->required();
    add_surface_options(command, o.picture);
    command->add_option("--design", o.picture.design, "design file or shipped name")->capture_default_str();
}

void add_sheet(CLI::App& app, CommandLine& line) {
    SheetOptions& o = line.sheet;
    CLI::App* command =
        add_command(app, line, "sheet", "contact sheet: one labelled picture a technique", [&o](Console& console) {
            if (o.sheet == kDisplaySheetName) return run_display_sheet(o, console);
            if (o.sheet == kGallerySheetName) return run_gallery_sheet(o, console);
            if (o.sheet == kReadmeSheetName) return run_readme_sheet(o, console);
            return o.sheet == kTraceSheetName ? run_trace_sheet(o, console) : run_sheet(o, console);
        });
    command
        ->add_option("SHEET", o.sheet,
                     "sheet file or shipped name, such as terrain-styles; trace: the ray tracer's presets and operators; "
                     "display: the parts of the display by their names; gallery: the story of the default flight; readme: "
                     "README.md's pictures")
        ->required();
    command->add_option("-o", o.output, "folder to write to")->required();
    command->add_option_function<std::string>(
        "--pose", [&o](const std::string& text) { o.pose = pose_from(text); },
        "lat,lon,alt_m,heading,pitch,roll; default: the sheet's");
    add_time(command, o.time);
    command->add_flag("--layers", o.layers, kLayersText);
    add_surface_options(command, o.picture);
    command->get_option("--terrain")->description("terrain database (.tdb); default: built from the sheet's raster");
    command->get_option("--scene")->description("scene database (.sdb); default: built from the sheet's scene");
    command->get_option("--size")->description("WIDTHxHEIGHT of a picture; default: the sheet's");
}

void add_sweep(CLI::App& app, CommandLine& line) {
    SweepOptions& o = line.sweep;
    CLI::App* command = add_command(app, line, "sweep", "a place from viewpoints round it: clutter, and what draws the eye",
                                    [&o](Console& console) { return run_sweep(o, console); });
    command->add_option_function<std::string>(
        "--around", [&o](const std::string& text) { o.place = place_from(text); },
        "lat,lon or lat,lon,alt_m of the place; default: the middle of the terrain, on the ground");
    command->add_option("--radius", o.radius_m, "metres that the place reaches round that")
        ->check(CLI::Range(1.0, 100'000.0))
        ->capture_default_str();
    command->add_option("--bearings", o.rings.bearings, "viewpoints of a ring, evenly from north over east")
        ->check(CLI::Range(std::size_t{1}, SweepRings::kMaxBearings))
        ->capture_default_str();
    command->add_option_function<std::string>(
        "--distances",
        [&o](const std::string& text) {
            o.rings.distances_m = metres_from("--distances", text, SweepRings::kMinDistance_m, SweepRings::kMaxDistance_m);
        },
        "metres from the place to the rings; default: 3000,6000");
    command->add_option_function<std::string>(
        "--heights",
        [&o](const std::string& text) {
            o.rings.heights_m = metres_from("--heights", text, -SweepRings::kMaxHeight_m, SweepRings::kMaxHeight_m);
        },
        "metres of the rings above the place; default: 300,1000");
    command->add_option("-o", o.output, "folder to write to: pictures, sweep.json, report.html")->required();
    add_time(command, o.time);
    command->add_option_function<std::string>(
        "--phase", [&o](const std::string& text) { o.phase = phase_from(text); },
        "flight phase, as if a switch stated it; default: none is stated");
    command->add_flag("--layers", o.layers, kLayersText);
    add_picture_options(command, o.picture);
    command->get_option("--terrain")
        ->description("terrain database (.tdb); default: the shipped one, with the shipped scenario's data");
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
    line.replay.strict = given.strict;
    line.replay.yes = given.yes;
    line.replay.tour = given.tour;
    line.replay.video = given.video;
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
    add_optional(
        command, "--spread", o.spread,
        "about so many frames, evenly from --from to --to, and one where a phase or a terrain alert begins; instead of --step")
        ->check(CLI::Range(2u, kMaxSpread))
        ->excludes("--step");
    command->add_flag("--over-terrain", o.over_terrain,
                      "from where the flight first comes over the terrain to where it last leaves it, between --from and --to");
    static const std::map<std::string, FrameOutput> kOutputs{
        {"png", FrameOutput::png}, {"hash", FrameOutput::hash}, {"none", FrameOutput::none}};
    command->add_option_function<std::string>(
        "--frames", [&o](const std::string& word) { o.frames = choice_from("--frames", word, kOutputs); },
        "png, hash or none; default: png, with --window hash");
}

void add_ghosts(CLI::App* command, ReplayOptions& o) {
    static const std::map<std::string, GhostAlign> kAlign = {
        {"time", GhostAlign::time}, {"place", GhostAlign::place}, {"takeoff", GhostAlign::takeoff}};
    CLI::Option* ghost =
        command
            ->add_option("--ghost", o.ghosts,
                         "log of another flight that is shown beside this one, with its name and its way; may be "
                         "repeated, 4 at most")
            ->allow_extra_args(false);
    command
        ->add_option_function<std::string>(
            "--ghost-align", [&o](const std::string& word) { o.ghost_align = choice_from("--ghost-align", word, kAlign); },
            "which moment of it is shown: time (of the same UTC), place (nearest to the own ship's place) or takeoff (equally "
            "long after take-off)")
        ->default_str("time")
        ->needs(ghost);
}

void add_replay(CLI::App& app, CommandLine& line) {
    ReplayOptions& o = line.replay;
    CLI::App* command = add_command(app, line, "replay", "recorded bus through the core: frames, records and a report",
                                    [&line](Console& console) { return run_replay_line(line, console); });
    command->add_option("LOG", o.log, "candump log");
    command->add_option("--switches", o.switches, "switch log");
    command->add_option("--switch-config", o.switch_config, "file or shipped name")->capture_default_str();
    command->add_option_function<std::string>(
        "--phase", [&o](const std::string& text) { o.phase = text == kNoPhase ? text : phase_from(text); },
        "flight phase of the whole run, as if a switch stated it; none: motion states none; default: as recorded");
    add_class(command, o.aircraft_class, "that of the aircraft file");
    add_replay_instants(command, o);
    command->add_option("--bus", o.picture.bus, "bus file or shipped name: how the log's frames are read")->capture_default_str();
    add_picture_options(command, o.picture);
    add_legend(command, o.picture);
    add_ghosts(command, o);
    add_accuracy_shown(command, o.accuracy);
    CLI::Option* layers = command->add_flag("--layers", o.layers, kLayersText);
    CLI::Option* ledger = command->add_flag(
        "--ledger", o.ledger, "what every effect that is replaced or left out would cost and show; ledger.json and ledger/");
    line.replay_config_holds = command->get_options(
        [](const CLI::Option* option) { return !option->check_name("--help") && !option->check_name("--json"); });
    command->add_option("-o", o.output, "folder to write to")->required();
    add_strict(command, o.strict);
    command->add_flag("--yes", o.yes, "begins a run of more than 20,000 frames or 4 GB without a question");
    command->add_option("--save-config", o.save_config,
                        "writes data, design and parameters of this replay to a file, after --window with its switches");
    CLI::Option* video = command->add_option(
        "--video", o.video,
        "film of the pictures (.mp4), also with --frames none: one a step, so that it runs as the flight did");
    CLI::Option* window = command->add_flag("--window", o.window, "in a window on the screen, with the keys below")
                              ->excludes(ledger)
                              ->excludes(layers)
                              ->excludes(video)
                              ->excludes("--over-terrain")
                              ->excludes("--spread");
    video->excludes("--spread");
    command->add_option("--tour", o.tour, "path file (CSV) that the window's camera follows")->needs(window);
    command->add_option(
        "--config", line.replay_config,
        "a file that --save-config wrote; beside it only -o, --strict, --yes, --save-config, --video, --window and --tour");
    command->footer(window_keys_help());
}

}  // namespace

void add_displays(CLI::App& app, CommandLine& line) {
    add_shot(app, line);
    add_sheet(app, line);
    add_sweep(app, line);
    add_trace(app, line);
    add_calibrate(app, line);
    add_accuracy(app, line);
    add_shaders(app, line);
    add_replay(app, line);
}

}  // namespace tedavis::host_sim
