#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/display_options.hpp"
#include "host_sim/commands/display_sheet.hpp"
#include "host_sim/commands/gallery_sheet.hpp"
#include "host_sim/commands/option_checks.hpp"
#include "host_sim/commands/option_texts.hpp"
#include "host_sim/commands/readme_sheet.hpp"
#include "host_sim/commands/trace_sheet.hpp"

namespace tedavis::host_sim {
namespace {

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
    CLI::App* command = add_long_command(app, line, "calibrate",
                                         "what every effect and quality level costs on this machine, as a file for --costs",
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
    CLI::App* command = add_long_command(app, line, "shaders", "a design's programs as binaries, for a device without a compiler",
                                         [&o](Console& console) { return run_shaders(o, console); });
    command->add_option("-o", o.output, "folder to write to; a board file names it as its programs")->required();
    add_surface_options(command, o.picture);
    command->add_option("--design", o.picture.design, "design file or shipped name")->capture_default_str();
}

void add_sheet(CLI::App& app, CommandLine& line) {
    SheetOptions& o = line.sheet;
    CLI::App* command =
        add_long_command(app, line, "sheet", "contact sheet: one labelled picture a technique", [&o](Console& console) {
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
    CLI::App* command = add_long_command(app, line, "sweep", "a place from viewpoints round it: clutter, and what draws the eye",
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

void add_device(CLI::App& app, CommandLine& line) {
    static const std::map<std::string, effects::Lane> kLanes = {{"es2", effects::Lane::es2}, {"es3", effects::Lane::es3}};
    CLI::App* group = app.add_subcommand("device", "the device file of a display computer");
    group->require_subcommand(1);
    DevicePlanOptions& o = line.device_plan;
    CLI::App* command = add_long_command(*group, line, "plan", "a device file whose budgets fit a memory, proved by a start",
                                         [&o](Console& console) { return run_device_plan(o, console); });
    command
        ->add_option_function<std::string>(
            "--size", [&o](const std::string& text) { o.picture.size = size_from(text); }, "WIDTHxHEIGHT of the picture")
        ->required();
    command
        ->add_option("--memory", o.memory,
                     "bytes for processor and GPU together; K, M or G behind them mean 1024 of the one before")
        ->required();
    command->add_option("--design", o.picture.design, "design file or shipped name that it must start with")
        ->capture_default_str();
    command->add_option("--scene", o.picture.scene, "scene database (.sdb) that it must hold, and the next one of this size");
    command->add_option("--terrain", o.picture.terrain, "terrain database (.tdb) that it is for; default: any");
    command->add_option_function<std::string>(
        "--lane", [&o](const std::string& word) { o.lane = choice_from("--lane", word, kLanes); },
        "es2 or es3; default: that of the largest shipped device that the memory holds");
    command->add_option("--rate", o.rate_hz, "pictures a second")->capture_default_str();
    command->add_option("-o", o.output, "the device file to write (.toml)")->required();
}

}  // namespace

void add_displays(CLI::App& app, CommandLine& line) {
    add_shot(app, line);
    add_sheet(app, line);
    add_sweep(app, line);
    add_trace(app, line);
    add_device(app, line);
    add_calibrate(app, line);
    add_accuracy(app, line);
    add_shaders(app, line);
    add_replay(app, line);
}

}  // namespace tedavis::host_sim
