#include "host_sim/commands/record.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/built_inputs.hpp"
#include "host_sim/commands/record_board.hpp"
#include "host_sim/commands/verify_board.hpp"
#include "host_sim/flight_test/fly_flight_test.hpp"
#include "host_sim/flight_test/read_steps.hpp"
#include "host_sim/flight_test/recorded_script.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/version.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNotRecorded = "interrupted; no flight test was written";

/// What was watched of the flight, and what is expected of it.
struct Recording {
    RecordedExpectations expectations;
    WatchedFlight flight;
    double from_s = 0, to_s = 0;
};

void check_record_options(const RecordOptions& options) {
    if (!options.at_s.empty() && (options.from_s || options.to_s))
        throw UserError("--at beside --from or --to; say single times or a span");
    if (options.from_s && options.to_s && *options.to_s < *options.from_s)
        throw UserError("--to lies before --from; exchange them");
    std::error_code error;
    if (fs::exists(options.output, error) && !options.yes)
        throw UserError(options.output + ": is there already, perhaps edited; name another script, or replace it with --yes");
    const std::string log = log_beside(options.output);
    if (!options.target.empty() && fs::exists(log, error) && !options.yes)
        throw UserError(log +
                        ": is there already, and the log of the bus is written there; name another script, or replace both with "
                        "--yes");
}

/// In a script "$" stands for a parameter.
std::string without_parameters(const std::string& text) {
    if (text.empty() || (text[0] != '$' && text.find("${") == std::string::npos)) return text;
    throw UserError(text + ": a script takes $ for a parameter; rename this file");
}

/// A file of configs/, by its name where it is a shipped one.
std::string config_in_script(const std::string& stated, const std::string& folder, const std::string& script_folder) {
    if (stated.empty()) return stated;
    const std::string path = resolve_config(stated, folder);
    const std::string shipped = shipped_root() + "/configs/" + folder + "/" + stated + ".toml";
    const bool is_bare = stated.find_first_of("./") == std::string::npos;
    return without_parameters(is_bare && path == shipped ? stated : path_in_script(path, script_folder));
}

/// A file, or the name of what a script has built.
std::string input_in_script(const std::string& stated, const std::string& script_folder) {
    std::error_code error;
    const bool is_bare = stated.find_first_of("./") == std::string::npos;
    if (stated.empty() || (is_bare && !fs::exists(stated, error))) return stated;
    return without_parameters(path_in_script(stated, script_folder));
}

std::string unless(const std::string& stated, const std::string& without) { return stated == without ? "" : stated; }

/// Title, settings and input, as the options name them.
RecordedScript script_of_input(const FlightTest& test, const RecordOptions& options) {
    const std::string folder = fs::path(options.output).parent_path().string();
    const PictureOptions& picture = test.picture;
    const std::string input = test.scenario.empty() ? fs::path(test.log).filename().string() : test.scenario;
    RecordedScript script;
    script.title = without_parameters("Recorded: " + input);
    script.settings = {{"design", unless(config_in_script(picture.design, "designs", folder), PictureOptions().design)},
                       {"device", unless(config_in_script(picture.device, "devices", folder), "es2-small")},
                       {"bus", unless(config_in_script(picture.bus, "buses", folder), PictureOptions().bus)},
                       {"switches", unless(config_in_script(test.switch_config, "switches", folder), "one_hot")},
                       {"aircraft", config_in_script(picture.aircraft, "aircraft", folder)},
                       {"terrain", input_in_script(picture.terrain, folder)},
                       {"scene", input_in_script(picture.scene, folder)}};
    script.input = {{"log", input_in_script(test.log, folder)},
                    {"switch_log", input_in_script(test.switch_log, folder)},
                    {"scenario", test.scenario}};
    return script;
}

/// A file without a dot in its name is a path, too.
void require_inputs(FlightTest& test) {
    for (std::string* const path : {&test.log, &test.switch_log, &test.picture.terrain, &test.picture.scene}) {
        std::error_code error;
        const bool is_bare = path->find_first_of("./") == std::string::npos;
        if (is_bare && fs::is_regular_file(*path, error)) *path = "./" + *path;
    }
    for (const std::string& path : {test.log, test.switch_log})
        if (!path.empty()) require_regular_file(path);
}

WatchedAlerts watched_alerts(const PictureOptions& picture) {
    return {!picture.terrain.empty(), !picture.terrain.empty() && !picture.scene.empty()};
}

Recording recording_of(const FactTracks& tracks, double rate_hz, double margin_s) {
    Recording recording;
    RecordingRule rule;
    rule.margin_s = margin_s;
    rule.rate_hz = rate_hz;
    recording.expectations = expectations_of(tracks, rule);
    recording.from_s = tracks.first_s();
    recording.to_s = tracks.last_s();
    return recording;
}

Recording record_span(const FlightTest& test, TestDisplay& display, const FlyTestSettings& settings, const RecordOptions& options,
                      Console& console) {
    FactTracks tracks(watched_alerts(test.picture));
    const FrameWatcher watcher{[&](const ObservedFrame& frame) { tracks.take(frame); },
                               [&](std::uint64_t done, std::uint64_t total) { console.progress("recording", done, total); }};
    const RecordedSpan span = recorded_span(options);
    const WatchedFlight flight = watch_flight(test, display, settings, {span.from_s.value_or(0), span.to_s, {}}, watcher);
    Recording recording = recording_of(tracks, flight.rate_hz, options.margin_s);
    recording.flight = flight;
    return recording;
}

Recording record_times(const FlightTest& test, TestDisplay& display, const FlyTestSettings& settings,
                       const RecordOptions& options) {
    WatchedTimes times;
    times.at_s = options.at_s;
    std::sort(times.at_s.begin(), times.at_s.end());
    times.at_s.erase(std::unique(times.at_s.begin(), times.at_s.end()), times.at_s.end());
    const WatchedAlerts alerts = watched_alerts(test.picture);
    Recording recording;
    auto& list = recording.expectations.list;
    const auto take = [&](const ObservedFrame& frame) {
        list.push_back(expectation_at(times.at_s[list.size()], facts_of(frame, alerts)));
    };
    recording.flight = watch_flight(test, display, settings, times, {take, nullptr});
    recording.from_s = times.at_s.front();
    recording.to_s = times.at_s.back();
    return recording;
}

Recording record_flight(FlightTest& test, const RecordOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const TemporaryFolder work;
    try {
        BuiltInputs(work.path(), console).resolve(test);
        TestDisplay display;
        const FlyTestSettings settings{work.path(), false, [&] { return interrupt.requested(); }};
        Recording recording = options.at_s.empty() ? record_span(test, display, settings, options, console)
                                                   : record_times(test, display, settings, options);
        console.progress_done();
        if (interrupt.requested()) throw Interrupted(kNotRecorded);
        return recording;
    } catch (const Interrupted&) {
        throw Interrupted(kNotRecorded);
    }
}

/// A running display.
Recording listen(const FlightTest& test, const RecordOptions& options, const BoardFile& board, std::ostream& log,
                 Console& console) {
    try {
        FactTracks tracks({!test.picture.terrain.empty(), false});  // records of a board do not say whether obstacles are watched
        const std::uint64_t frames = record_live_board(options, board, log, tracks, console);
        Recording recording = recording_of(tracks, board.rate_hz, options.margin_s);
        recording.flight = {board.rate_hz, frames};
        return recording;
    } catch (const Interrupted&) {
        throw Interrupted(kNotRecorded);
    }
}

std::string seconds_words(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", seconds);
    return text;
}

std::vector<std::string> notes_of(const Recording& recording, const RecordOptions& options) {
    std::vector<std::string> notes = {std::string("Written by tedavis record, version ") + version() + ", from " +
                                      std::to_string(recording.flight.frames) + " frames, " + seconds_words(recording.from_s) +
                                      " to " + seconds_words(recording.to_s) +
                                      ". It expects what was shown, right or wrong: read it, and edit it."};
    if (options.at_s.empty())
        notes.push_back("What changes is expected within " + seconds_words(options.margin_s) +
                        " before and after the change, what lasts from so long after its beginning to so long before its end.");
    if (recording.to_s + 1 > kLatestTestTime_s)
        notes.push_back("The flight may go on: times of a script end at " + seconds_words(kLatestTestTime_s) + ".");
    if (!options.target.empty())
        notes.push_back(
            "Recorded of a running display: the log beside it begins in flight, so what stands in its first seconds is not "
            "expected; what takes longer to be known again (motion) is yours to remove.");
    if (!recording.expectations.left_out.empty())
        notes.push_back("Left out, so that it can be read: " + recording.expectations.left_out + ".");
    return notes;
}

nlohmann::ordered_json record_json(const Recording& recording, const RecordOptions& options) {
    const RecordedExpectations& expectations = recording.expectations;
    return {
        {"script", options.output},
        {"expectations", expectations.list.size()},
        {"frames", recording.flight.frames},
        {"from_s", recording.from_s},
        {"to_s", recording.to_s},
        {"left_out", expectations.left_out.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(expectations.left_out)}};
}

}  // namespace

int run_record(const RecordOptions& options, Console& console) {
    check_record_options(options);
    const std::optional<BoardFile> board = stated_board(options.target, options.board, options.interface_name);
    FlightTest test = board ? board_input(options, *board) : recorded_input(options);
    std::optional<AtomicFile> log;
    if (board) {
        require_replaceable_log(test.log);
        log.emplace(test.log);
    } else {
        require_inputs(test);
    }
    require_other_file(options.output, {test.log, test.switch_log, test.picture.terrain, test.picture.scene, test.picture.design,
                                        test.picture.device, test.picture.bus, test.picture.aircraft, test.switch_config});
    RecordedScript script = script_of_input(test, options);
    AtomicFile file(options.output);
    Recording recording = board ? listen(test, options, *board, log->stream(), console) : record_flight(test, options, console);
    if (recording.expectations.list.empty())
        throw UserError((board ? options.target : options.input) +
                        ": too short to expect anything of it; say a longer span, or a smaller --margin");
    script.notes = notes_of(recording, options);
    script.expectations = recording.expectations.list;
    file.stream() << recorded_script_text(script);
    require_uninterrupted(options.output);
    if (log) log->commit();
    file.commit();
    if (!recording.expectations.left_out.empty()) console.note("note: left out: " + recording.expectations.left_out);
    console.result(options.output + ": " + std::to_string(recording.expectations.list.size()) + " expectations of " +
                       std::to_string(recording.flight.frames) + " frames; edit it, and fly it with tedavis verify " +
                       options.output,
                   json_text(record_json(recording, options)));
    return 0;
}

}  // namespace tedavis::host_sim
