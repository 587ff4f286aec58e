#include "host_sim/commands/replay.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "host_sim/accuracy/accuracy_overlay.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/replay/closest_finder.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/effect_ledger.hpp"
#include "host_sim/replay/flight_events.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_instants.hpp"
#include "host_sim/replay/frame_preroll.hpp"
#include "host_sim/replay/generated_flight.hpp"
#include "host_sim/replay/ghost_flights.hpp"
#include "host_sim/replay/interval_store.hpp"
#include "host_sim/replay/ledger_report.hpp"
#include "host_sim/replay/run_estimate.hpp"
#include "host_sim/replay/run_recorder.hpp"
#include "host_sim/replay/started_pack.hpp"
#include "host_sim/replay/terrain_span.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/window/live_window.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kBeforeFirstFrame = "what the flight leaves on the display before the first frame";

void enter(EffectLedger& ledger, std::uint64_t n, base::Time time, const FrameResult& drawn, const RunRecorder& recorder,
           const DisplaySession& session) {
    ledger.note(drawn.record);
    if (!ledger.wants(n)) return;
    const flight::FrameInput& input = recorder.input();
    ledger.take({drawn.record.frame, time, input.state, input.phase, input.legend, *input.trail, upright(session.pixels())});
}

void price_effects(const EffectLedger& ledger, const ReplayOptions& options, DisplaySession& session,
                   const InterruptGuard& interrupt, Console& console) {
    session.rest();
    const std::vector<LedgerPrice> prices = ledger.prices([&](std::size_t done, std::size_t total) {
        console.progress("ledger", done, total);
        if (interrupt.requested()) throw Interrupted("interrupted; the run is whole, its ledger was not written");
    });
    console.progress_done();
    write_ledger(options.output, ledger_json(prices, ledger.samples(), options.picture.device), prices);
    console.note(options.output + "/" + kLedgerName + ":\n" + ledger_text(prices));
}

/// Opened before the run's folder changes, and may lie in it. Null where none is asked for.
std::unique_ptr<VideoFile> opened_video(const ReplayOptions& options, const DisplaySession& session, const FrameInstants& times) {
    if (options.video.empty()) return nullptr;
    namespace fs = std::filesystem;
    NewFolder folder(options.output);
    VideoSettings settings;
    settings.path = options.video;
    settings.width = session.width();
    settings.height = session.height();
    settings.step_s = std::abs(times.step().to_seconds());
    settings.title = "TEDAVIS, design " + fs::path(options.picture.design).stem().string() + ", " +
                     fs::path(options.log).filename().string() + ", not for navigation";
    settings.begin = times.at(0);
    auto video = std::make_unique<VideoFile>(settings);
    folder.keep();
    return video;
}

void fly(const ReplayOptions& options, const FrameInstants& times, FramePreroll& preroll, RunRecorder& recorder,
         EffectLedger& ledger, DisplaySession& session, const InterruptGuard& interrupt, Console& console) {
    preroll.set_told([&](std::uint64_t done, std::uint64_t total) {
        console.progress(kBeforeFirstFrame, done, total);
        return !interrupt.requested();
    });
    for (std::uint64_t n = 0; n < times.count() && !interrupt.requested(); ++n) {
        if (!preroll.preroll(times.at(n))) break;
        const FrameResult& drawn = recorder.draw(times.at(n));
        recorder.keep();
        if (options.ledger) enter(ledger, n, times.at(n), drawn, recorder, session);
        console.progress("replay", n + 1, times.count());
    }
    console.progress_done();
}

/// Empty where the options ask for no parts.
TimeRanges parts_of(const ReplayOptions& options, const FlightPlayer& player, DisplaySession& session) {
    if (!options.over_terrain) return {};
    return terrain_spans(options, player.outline(), player.first(), session.display().planner().terrain_database());
}

constexpr std::uint64_t kFramesForEachEvent = 4;  // so that a restless flight has a quarter more frames at most

/// Where the options spread frames over the flight, its events have frames too.
FrameInstants instants_of(const ReplayOptions& options, const TimeRanges& parts, FlightPlayer& player, DisplaySession& session,
                          FramePreroll& preroll, Console& console) {
    FrameInstants times(options, player.first(), player.last(), session.device().frame_rate_hz, parts);
    if (!options.spread) return times;
    const std::uint64_t most = std::max<std::uint64_t>(*options.spread / kFramesForEachEvent, 1);
    const auto of_flight = [&](base::Time time) { return static_cast<std::uint64_t>((time - player.first()).ns); };
    times.add(event_instants(player, preroll, times.parts(), most, [&](base::Time reached) {
        console.progress("looking for alerts", of_flight(reached), of_flight(times.parts().back().to));
        require_uninterrupted(options.output);
    }));
    console.progress_done();
    return times;
}

constexpr std::size_t kClosestShown = 3;

/// Where the options spread frames over the flight, its closest points to the terrain have frames too: these are returned.
std::vector<base::Time> add_closest(const ReplayOptions& options, FlightPlayer& player, DisplaySession& session,
                                    FrameInstants& times) {
    const terrain::TerrainDatabase* const database = session.display().planner().terrain_database();
    if (!options.spread || database == nullptr) return {};
    ClearanceMeter meter(*database);
    std::vector<base::Time> frames =
        closest_instants(player, meter, {times.parts().front().from, times.parts().back().to}, kClosestShown);
    require_uninterrupted(options.output);
    for (base::Time& instant : frames) instant = times.frame_at_or_after(instant);
    times.add(frames);
    return frames;
}

void require_consent_to(const ReplayOptions& options, const FrameInstants& times, FlightPlayer& player, DisplaySession& session,
                        Console& console) {
    if (times.count() > kFramesWithoutAWord) require_consent(estimate_run(options, times, player, session), options, console);
}

/// What the run says about itself, and what is drawn over its pictures; `overlay` must outlive the recorder.
void prepare(RunRecorder& recorder, const ReplayOptions& options, const AccuracyOverlay& overlay, const TimeRanges& parts,
             const FlightPlayer& player) {
    if (options.accuracy.any())
        recorder.set_overlay([&overlay](DisplaySession& drawn, FrameResult& result) { return overlay.over(drawn, result); });
    if (!parts.empty()) recorder.note(words_of_spans(parts, player.first(), options.picture.terrain));
    for (const std::string& note : options.notes) recorder.note(note);
}

int run_batch(const ReplayOptions& options, const InterruptGuard& interrupt, Console& console) {
    const AccuracyOverlay overlay({options.accuracy}, options.picture.terrain);
    const std::optional<DisplayFiles> files = IntervalStore::files_before_start(options);
    DisplaySession session(options.picture, is_generated_flight(options.log));
    require_uninterrupted(options.output);
    FlightPlayer player(player_files(options), session.display(), &console, index_policy(options));
    const std::string age = words_of_started(options.pack, player.first());
    if (!age.empty()) console.note("note: " + age);
    const TimeRanges parts = parts_of(options, player, session);
    FramePreroll preroll(player, session, session.device().frame_rate_hz);
    const IntervalStore store(options, files, session, player, preroll, console);
    FrameInstants times = instants_of(options, parts, player, session, preroll, console);
    const std::vector<base::Time> closest = add_closest(options, player, session, times);
    require_consent_to(options, times, player, session, console);
    require_uninterrupted(options.output);
    const std::unique_ptr<VideoFile> video = opened_video(options, session, times);
    RunRecorder recorder(options, session, player);
    if (video) recorder.set_video(*video);
    prepare(recorder, options, overlay, parts, player);
    recorder.set_closest(closest);
    if (!age.empty()) recorder.note(age);
    if (!options.save_config.empty()) save_replay_config(options, options.save_config);
    EffectLedger ledger(options.picture, {session.width(), session.height()}, is_generated_flight(options.log),
                        options.ledger ? times.count() : 0);
    fly(options, times, preroll, recorder, ledger, session, interrupt, console);
    const int code = recorder.finish(interrupt.requested(), console);
    if (options.ledger && (code == 0 || code == kCheckFailedExitCode))
        price_effects(ledger, options, session, interrupt, console);
    return code;
}

}  // namespace

int run_replay(const ReplayOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const auto run = [&](const ReplayOptions& shown) {
        return shown.window ? run_live_window(shown, console) : run_batch(shown, interrupt, console);
    };
    if (options.ghosts.empty()) return run(options);
    const TemporaryFolder folder;
    ReplayOptions with_ghosts = options;
    with_ghosts.picture.ghosts = make_ghosts(options, folder.path(), console);
    return run(with_ghosts);
}

}  // namespace tedavis::host_sim
