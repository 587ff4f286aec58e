#include "host_sim/commands/replay.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/replay_config.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/reports/frame_record_writer.hpp"
#include "host_sim/reports/html_report.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

double milliseconds_between(base::Time a, base::Time b) { return (b - a).to_seconds() * 1000; }

/// The instants to draw: from .. to in steps, both ends included, backwards for a negative step.
class FrameInstants {
public:
    FrameInstants(const ReplayOptions& options, const FlightPlayer& player, double rate_hz) : origin_(player.first()) {
        const double end_s = (player.last() - player.first()).to_seconds();
        const double from_s = options.from_s.value_or(0), to_s = options.to_s.value_or(end_s),
                     step_s = options.step_s.value_or(1 / rate_hz);
        if (!(from_s >= 0 && from_s <= end_s))
            throw UserError("--from " + std::to_string(from_s) + ": the log lasts " + std::to_string(end_s) +
                            " s; choose a time inside it");
        if (!(to_s >= from_s)) throw UserError("--to " + std::to_string(to_s) + ": lies before --from; give a later time");
        if (!(std::abs(step_s) >= 1e-3))
            throw UserError("--step " + std::to_string(step_s) + ": must be at least 0.001 s, or negative to go backwards");
        // Times are whole steps from the log's start where --from is one, so that a part of a run has the whole run's instants.
        from_ = base::Duration::from_seconds(from_s);
        step_ = base::Duration::from_seconds(std::abs(step_s));
        count_ = static_cast<std::uint64_t>((base::Duration::from_seconds(std::min(to_s, end_s)) - from_).ns / step_.ns) + 1;
        backwards_ = step_s < 0;
    }
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] base::Time at(std::uint64_t n) const {
        const auto k = static_cast<std::int64_t>(backwards_ ? count_ - 1 - n : n);
        return origin_ + from_ + base::Duration{step_.ns * k};
    }

private:
    base::Time origin_;
    base::Duration from_, step_;
    std::uint64_t count_ = 0;
    bool backwards_ = false;
};

/// Draws the instants one by one into the run's folder.
class ReplayRun {
public:
    ReplayRun(const ReplayOptions& options, DisplaySession& session, FlightPlayer& player, Console& console)
        : options_(options),
          session_(session),
          player_(player),
          console_(console),
          records_(options.output, player.first()),
          story_(player.first()) {}

    void run(const FrameInstants& times) {
        const InterruptGuard interrupt;
        for (std::uint64_t n = 0; n < times.count() && !interrupt.requested(); ++n) {
            draw_frame(times.at(n));
            console_.progress("replay", n + 1, times.count());
        }
        interrupted_ = interrupt.requested();
        console_.progress_done();
        records_.commit();
    }

    [[nodiscard]] RunSummary summary() {
        RunSummary s;
        s.frames = records_.written();
        const FrameTimes times = frame_times(total_ms_);
        s.fps_median = times.median_ms > 0 ? 1000 / times.median_ms : 0;
        s.ms_p99 = times.p99_ms;
        s.worst_error_px = worst_error_px_;
        s.gl_calls_outside_device = session_.display().gl().denied().total;
        s.device = options_.picture.device;
        s.design = options_.picture.design;
        s.terrain = options_.picture.terrain;
        s.scene = options_.picture.scene;
        s.log = options_.log;
        s.switches = options_.switches;
        s.width = session_.width();
        s.height = session_.height();
        s.costs = options_.picture.costs;
        s.gl = session_.gl_description();
        const bus::BusCounters counters = player_.counters_of_whole_log();
        s.can = {counters.frames, counters.decoded, counters.alien, counters.errors, counters.dropped};
        s.interrupted = interrupted_;
        s.notes = player_.notes();
        return s;
    }
    [[nodiscard]] const RunStory& story() const { return story_; }

private:
    void draw_frame(base::Time time) {
        FrameResult result;
        const PlayedInstant instant = player_.at(time);
        const base::Time start = platform::monotonic_now();
        session_.display().update(instant.aircraft, instant.phase, time);
        const base::Time planned = platform::monotonic_now();
        session_.draw();
        const base::Time drawn = platform::monotonic_now();
        result.record = session_.display().record();
        result.timing = {milliseconds_between(start, planned), milliseconds_between(planned, drawn),
                         milliseconds_between(start, drawn)};
        result.latency_ms = milliseconds_between(instant.newest_frame, time);
        if (options_.frames != FrameOutput::none) result.hash = session_.frame_hash();
        records_.write(result);
        total_ms_.push_back(result.timing.total_ms);
        worst_error_px_ = std::max(worst_error_px_, result.record.terrain.worst_error_px);
        const double above = instant.aircraft[Signal::height_above_terrain].value_or(std::nan(""));
        if (story_.add(result, above, instant.aircraft[Signal::ground_speed].value_or(0)))
            story_.add_picture(result, session_.pixels());
        if (options_.frames == FrameOutput::png)
            write_png(frame_picture_path(options_.output, result.record.frame), session_.pixels());
    }

    const ReplayOptions& options_;
    DisplaySession& session_;
    FlightPlayer& player_;
    Console& console_;
    FrameRecordWriter records_;
    RunStory story_;
    std::vector<double> total_ms_;
    double worst_error_px_ = 0;
    bool interrupted_ = false;
};

/// A scenario leaves its manifest beside the flight; such a flight says on the display that it is generated.
bool is_generated_flight(const std::string& log) {
    const std::size_t slash = log.find_last_of('/');
    const std::string manifest = (slash == std::string::npos ? std::string() : log.substr(0, slash + 1)) + "scenario.json";
    if (std::FILE* file = std::fopen(manifest.c_str(), "rb")) {
        std::fclose(file);
        return true;
    }
    return false;
}

}  // namespace

int run_replay(const ReplayOptions& options, Console& console) {
    DisplaySession session(options.picture, is_generated_flight(options.log));
    FlightPlayer player({options.log, options.picture.bus, options.switches, options.switch_config}, session.display());
    const FrameInstants times(options, player, session.device().frame_rate_hz);
    make_folder(options.output);
    if (options.frames == FrameOutput::png) make_folder(options.output + "/" + kFramesFolder);
    if (!options.save_config.empty()) save_replay_config(options, options.save_config);
    ReplayRun run(options, session, player, console);
    run.run(times);
    const RunSummary summary = run.summary();
    write_run_reports(options.output, summary, run.story(), session.display().budget());
    char line[200];
    std::snprintf(line, sizeof line, ": %llu frames, %.1f frames/s median, worst terrain error %.2f px",
                  static_cast<unsigned long long>(summary.frames), summary.fps_median, summary.worst_error_px);
    console.result(options.output + line, run_summary_json(summary, session.display().budget()));
    return 0;
}

}  // namespace tedavis::host_sim
