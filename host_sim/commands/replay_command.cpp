#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/display_options.hpp"
#include "host_sim/commands/option_texts.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/window/window_keys.hpp"

namespace tedavis::host_sim {
namespace {

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

/// What was flown, and of that what is shown.
void add_replayed_flight(CLI::App* command, ReplayOptions& o) {
    command->add_option("LOG", o.log, "candump log");
    command->add_option("--switches", o.switches, "switch log");
    command->add_option("--switch-config", o.switch_config, "file or shipped name")->capture_default_str();
    command->add_option_function<std::string>(
        "--phase", [&o](const std::string& text) { o.phase = text == kNoPhase ? text : phase_from(text); },
        "flight phase of the whole run, as if a switch stated it; none: motion states none; default: as recorded");
    add_class(command, o.aircraft_class, "that of the aircraft file");
    add_replay_instants(command, o);
    command->add_option("--bus", o.picture.bus, "bus file or shipped name: how the log's frames are read")->capture_default_str();
}

/// All that a file of --config holds.
void add_replay_config_options(CLI::App* command, ReplayOptions& o) {
    add_replayed_flight(command, o);
    add_picture_options(command, o.picture);
    add_legend(command, o.picture);
    add_ghosts(command, o);
    add_accuracy_shown(command, o.accuracy);
    command->add_flag("--layers", o.layers, kLayersText);
    command->add_flag("--ledger", o.ledger,
                      "what every effect that is replaced or left out would cost and show; ledger.json and ledger/");
}

/// Where the run goes to, and who sees it.
void add_replay_output(CLI::App* command, ReplayOptions& o) {
    command->add_option("-o", o.output, "folder to write to")->required();
    add_strict(command, o.strict);
    command->add_flag("--yes", o.yes, "begins a run of more than 20,000 frames or 4 GB without a question");
    command->add_option("--save-config", o.save_config,
                        "writes data, design and parameters of this replay to a file, after --window with its switches");
    CLI::Option* video = command->add_option(
        "--video", o.video,
        "film of the pictures (.mp4), also with --frames none: one a step, so that it runs as the flight did");
    CLI::Option* window = command->add_flag("--window", o.window, "in a window on the screen, with the keys below")
                              ->excludes("--ledger")
                              ->excludes("--layers")
                              ->excludes(video)
                              ->excludes("--over-terrain")
                              ->excludes("--spread");
    video->excludes("--spread");
    command->add_option("--tour", o.tour, "path file (CSV) that the window's camera follows")->needs(window);
}

}  // namespace

void add_replay(CLI::App& app, CommandLine& line) {
    CLI::App* command = add_long_command(app, line, "replay", "recorded bus through the core: frames, records and a report",
                                         [&line](Console& console) { return run_replay_line(line, console); });
    add_replay_config_options(command, line.replay);
    line.replay_config_holds = command->get_options(
        [](const CLI::Option* option) { return !option->check_name("--help") && !option->check_name("--json"); });
    add_replay_output(command, line.replay);
    command->add_option(
        "--config", line.replay_config,
        "a file that --save-config wrote; beside it only -o, --strict, --yes, --save-config, --video, --window and --tour");
    command->footer(window_keys_help());
}

}  // namespace tedavis::host_sim
