#include <algorithm>
#include <iterator>

#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/display_options.hpp"
#include "host_sim/commands/option_texts.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/window/window_keys.hpp"

namespace tedavis::host_sim {
namespace {

using PutOption = void (*)(const ReplayOptions& given, ReplayOptions& options);

template <auto kMember>
void put_member(const ReplayOptions& given, ReplayOptions& options) {
    options.*kMember = given.*kMember;
}
void put_gl(const ReplayOptions& given, ReplayOptions& options) { options.picture.gl = given.picture.gl; }

/// Options of the flight, which go before those of a configuration: it says what the display is.
struct FlightOption {
    const char* name;
    PutOption put;
};
constexpr FlightOption kBeforeConfig[] = {{"LOG", put_member<&ReplayOptions::log>},
                                          {"--switches", put_member<&ReplayOptions::switches>},
                                          {"--phase", put_member<&ReplayOptions::phase>},
                                          {"--class", put_member<&ReplayOptions::aircraft_class>},
                                          {"--from", put_member<&ReplayOptions::from_s>},
                                          {"--to", put_member<&ReplayOptions::to_s>},
                                          {"--step", put_member<&ReplayOptions::step_s>},
                                          {"--spread", put_member<&ReplayOptions::spread>},
                                          {"--frames", put_member<&ReplayOptions::frames>},
                                          {"--over-terrain", put_member<&ReplayOptions::over_terrain>},
                                          {"--gl", put_gl},
                                          {"--ghost", put_member<&ReplayOptions::ghosts>},
                                          {"--ghost-align", put_member<&ReplayOptions::ghost_align>}};

/// Options of the run, which no configuration has.
constexpr PutOption kOfRun[] = {
    put_member<&ReplayOptions::output>, put_member<&ReplayOptions::window>, put_member<&ReplayOptions::strict>,
    put_member<&ReplayOptions::yes>,    put_member<&ReplayOptions::tour>,   put_member<&ReplayOptions::video>,
    put_member<&ReplayOptions::layers>, put_member<&ReplayOptions::ledger>, put_member<&ReplayOptions::save_config>};

bool is_given(const CommandLine& line, const char* option) { return line.replay_command->get_option(option)->count() > 0; }

/// What the file says of the flight that its own log holds.
void leave_own_log(ReplayOptions& options) {
    options.switches.clear();
    options.from_s.reset();
    options.to_s.reset();
    options.ghosts.clear();
    options.ghost_align = ReplayOptions().ghost_align;
}

/// What of the flight the command line says itself.
void put_given_flight(const CommandLine& line, const ReplayOptions& given, ReplayOptions& options) {
    if (is_given(line, "LOG")) leave_own_log(options);
    if (is_given(line, "--step")) options.spread.reset();
    if (is_given(line, "--spread")) options.step_s.reset();
    for (const FlightOption& option : kBeforeConfig)
        if (is_given(line, option.name)) option.put(given, options);
}

/// Of a configuration alone nothing is signed.
void require_pack_for_key(const CommandLine& line) {
    if (line.replay.pack.is_pack()) return;
    throw UserError("--pack-key " + line.pack_key + ": " + line.replay_config +
                    " is of no pack, so that no signature would be asked for; name a pack, or leave the key out");
}

/// What --config says, with what may stand beside it on the command line.
void use_replay_config(CommandLine& line) {
    if (line.replay_config.empty()) return;
    for (const CLI::Option* option : line.replay_config_holds)
        if (option->count() > 0)
            throw UserError("--config " + line.replay_config + ": this file says it already; leave out " + option->get_name());
    const bool names_key = is_given(line, "--pack-key");
    if (names_key) require_regular_file(line.pack_key);  // without the file no signature would be asked for
    const ReplayOptions given = line.replay;
    line.replay = load_replay_config(line.replay_config, line.pack_key);
    if (names_key) require_pack_for_key(line);
    put_given_flight(line, given, line.replay);
    for (const PutOption put_own : kOfRun) put_own(given, line.replay);
}

/// Options of --config that something else must not say, too.
bool is_held_by_config(const CLI::Option* option) {
    for (const char* name : {"--help", "--json", "--layers", "--ledger"})
        if (option->check_name(name)) return false;
    return std::none_of(std::begin(kBeforeConfig), std::end(kBeforeConfig),
                        [&](const FlightOption& before) { return option->check_name(before.name); });
}

int run_replay_line(CommandLine& line, Console& console) {
    use_replay_config(line);
    const std::string& from = line.replay_config.empty() ? std::string("replay") : line.replay_config;
    if (line.replay.log.empty()) throw UserError(from + ": no log named; give a candump log, or --config with one in [replay]");
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
    line.replay_command = command;
    line.replay_config_holds = command->get_options(&is_held_by_config);
    add_replay_output(command, line.replay);
    CLI::Option* config = command->add_option(
        "--config", line.replay_config,
        "configuration of desk and board (a board file, or one that --save-config wrote), or the folder of a pack; it says what "
        "the display is, and beside it stand options of the flight and of the run alone");
    command
        ->add_option("--pack-key", line.pack_key,
                     "public key of minisign that a pack must be signed with, where this file exists")
        ->capture_default_str()
        ->needs(config);
    command->footer(window_keys_help());
}

}  // namespace tedavis::host_sim
