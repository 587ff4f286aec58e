#include "host_sim/flight_test/fly_flight_test.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "host_sim/flight_test/input_logs.hpp"
#include "host_sim/flight_test/read_steps.hpp"
#include "host_sim/flight_test/session_picture.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_preroll.hpp"
#include "host_sim/replay/generated_flight.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/display/planner/effect_notes.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::host_sim {
namespace {

/// Those that the display warns of.
bool scene_has_obstacles(const display::SpatialData& data) {
    if (!data.has_scene()) return false;
    const base::Span<const scene::Layer> layers = data.scene().layers();
    return std::any_of(layers.begin(), layers.end(), [](const scene::Layer& layer) {
        const scene::LayerShape shape = layer.entry->shape;
        return layer.entry->role == scene::LayerRole::obstacle &&
               (shape == scene::LayerShape::points || shape == scene::LayerShape::lines);
    });
}

class TestFlight {
public:
    TestFlight(const FlightTest& test, DisplaySession& session, FlightPlayer& player, const FlyTestSettings& settings)
        : session_(session),
          player_(player),
          settings_(settings),
          rate_hz_(session.device().frame_rate_hz),
          preroll_(player, session, rate_hz_),
          picture_(session) {
        for (const Expectation& expectation : test.expectations) judges_.emplace_back(expectation, FrameTimes{rate_hz_});
        reads_text_ = std::any_of(test.expectations.begin(), test.expectations.end(),
                                  [](const Expectation& expectation) { return expectation.reads_text(); });
        preroll_.set_told([this](std::uint64_t, std::uint64_t) { return !is_interrupted(); });
        session_.display().memory().frames = 0;
        has_obstacles_ = scene_has_obstacles(session.display().planner().data());
    }

    FlightTestResult fly() {
        const std::int64_t last = last_frame();
        for (std::int64_t n = 0; n <= last; ++n) {
            const double time_s = static_cast<double>(n) / rate_hz_;
            const bool is_wanted = std::any_of(judges_.begin(), judges_.end(),
                                               [time_s](const ExpectationJudge& judge) { return judge.wants(time_s); });
            if (is_wanted) judge_frame(time_s);
            if (is_interrupted()) throw Interrupted(kTestInterrupted);
        }
        for (const ExpectationJudge& judge : judges_) result_.expectations.push_back(judge.result());
        return std::move(result_);
    }

    WatchedFlight watch(const WatchedTimes& times, const FrameWatcher& watcher) {
        const std::vector<std::int64_t> frames = watched_frames(times);
        std::uint64_t done = 0;
        for (const std::int64_t n : frames) {
            if (is_interrupted()) throw Interrupted(kTestInterrupted);
            watcher.take(plan(static_cast<double>(n) / rate_hz_));
            if (watcher.told) watcher.told(++done, frames.size());
        }
        return {rate_hz_, frames.size()};
    }

private:
    static constexpr double kSmallPart = 1e-4;  // of a frame, by which the log's end may miss it

    [[nodiscard]] double end_s() const { return (player_.last() - player_.first()).to_seconds(); }
    [[nodiscard]] std::int64_t last_frame() const {
        return static_cast<std::int64_t>(std::floor(end_s() * rate_hz_ + kSmallPart));
    }

    [[nodiscard]] std::int64_t frame_at_or_after(double time_s) const {
        const auto frame = static_cast<std::int64_t>(std::ceil(time_s * rate_hz_ - kSmallPart));
        if (frame <= last_frame()) return frame;
        char words[128];
        std::snprintf(words, sizeof words, "%g s: there is no frame, since the input ends after %.3f s; say an earlier time",
                      time_s, end_s());
        throw UserError(words);
    }

    [[nodiscard]] std::vector<std::int64_t> watched_frames(const WatchedTimes& times) const {
        std::vector<std::int64_t> frames;
        for (const double time_s : times.at_s) frames.push_back(frame_at_or_after(time_s));
        if (!times.at_s.empty()) return frames;
        const std::int64_t first = frame_at_or_after(times.from_s);
        if (times.to_s && *times.to_s > end_s()) static_cast<void>(frame_at_or_after(*times.to_s));
        const double to_s = std::min(times.to_s.value_or(end_s()), kLatestTestTime_s);
        const auto last = static_cast<std::int64_t>(std::floor(to_s * rate_hz_ + kSmallPart));
        for (std::int64_t n = first; n <= last; ++n) frames.push_back(n);
        return frames;
    }

    [[nodiscard]] bool is_interrupted() const { return settings_.is_interrupted && settings_.is_interrupted(); }

    void judge_frame(double time_s) {
        ++result_.frames;
        const ObservedFrame frame = plan(time_s);
        std::optional<std::size_t> failed;
        for (std::size_t n = 0; n < judges_.size(); ++n)
            if (judges_[n].wants(time_s) && judges_[n].take(frame) && !failed) failed = n;
        if (!failed || has_failed_) return;
        has_failed_ = true;
        result_.shown = *failed;
        result_.shown_s = time_s;
        if (settings_.draws_failure) draw_failure();
    }

    /// As a replay plans it; drawn only where later frames show it again, or a condition looks at its picture.
    ObservedFrame plan(double time_s) {
        const base::Time time = player_.first() + base::Duration::from_seconds(time_s);
        if (!preroll_.preroll(time)) throw Interrupted(kTestInterrupted);
        const flight::FrameInput input = player_.at(time);
        display::Display& display = session_.display();
        display.plan({input.state, input.phase, time, input.trail, input.legend});
        picture_.begin_frame();
        if (display.memory().must_be_drawn()) picture_.draw();
        ObservedFrame frame;
        frame.time_s = time_s;
        frame.picture = &picture_;
        frame.record = display.record();
        const display::PlannedFrame& plan = display.planned();
        if (!picture_.is_drawn())
            display::record_effects({plan.effects, plan.decisions, *plan.shown, plan.data.members, plan.maps_beside.drawn},
                                    frame.record);
        for (std::size_t n = 0; n < policy::kElementCount; ++n)
            frame.record.elements[n] = plan.decisions.elements[n].show;  // also of a frame that is not drawn
        latency_s_ = (time - player_.newest_frame()).to_seconds();
        frame.latency_frames = latency_s_ * rate_hz_;
        if (reads_text_) frame.words = words_of(input);
        frame.has_obstacles = has_obstacles_;
        for (std::size_t n = 0; n < flight::kSignalCount; ++n)
            frame.values.values[n] = input.state[static_cast<flight::Signal>(n)].value_or(std::nan(""));
        return frame;
    }

    /// The boxes of the layout are those of the input that the symbology was built from.
    [[nodiscard]] std::vector<PlacedWords> words_of(const flight::FrameInput& input) {
        display::Display& display = session_.display();
        const display::PlannedFrame& plan = display.planned();
        const draw::SymbologyInput shown =
            draw::make_symbology_input(input.state, plan.decisions, input.phase, *plan.shown, input.time, session_.width(),
                                       session_.height(), display.record().altitude_msl_m);
        const draw::Layout layout =
            draw::make_layout(session_.width(), session_.height(), plan.shown->view.dpi, draw::legend_need(shown));
        return placed_words(display.planner().symbology(), layout);
    }

    void draw_failure() {
        FrameResult drawn = picture_.result();
        drawn.hash = session_.frame_hash();
        drawn.latency_ms = latency_s_ * 1000;
        result_.picture = encode_png(session_.pixels());
        result_.record = frame_record_json(drawn, player_.first());
    }

    DisplaySession& session_;
    FlightPlayer& player_;
    const FlyTestSettings& settings_;
    double rate_hz_;
    FramePreroll preroll_;
    SessionPicture picture_;
    std::vector<ExpectationJudge> judges_;
    FlightTestResult result_;
    bool has_failed_ = false, reads_text_ = false, has_obstacles_ = false;
    double latency_s_ = 0;
};

/// Nothing is written beside the logs of a test.
IndexPolicy test_index_policy() {
    IndexPolicy policy;
    policy.smallest_kept_log = std::numeric_limits<std::uint64_t>::max();
    return policy;
}

}  // namespace

std::size_t FlightTestResult::held() const {
    return static_cast<std::size_t>(
        std::count_if(expectations.begin(), expectations.end(), [](const ExpectationResult& one) { return one.holds; }));
}

std::size_t FlightTestResult::failed() const {
    return static_cast<std::size_t>(std::count_if(expectations.begin(), expectations.end(),
                                                  [](const ExpectationResult& one) { return one.is_judged && !one.holds; }));
}

std::size_t FlightTestResult::not_judged() const {
    std::size_t count = 0;
    for (const ExpectationResult& one : expectations) count += one.not_judged;
    return count;
}

const ExpectationResult* FlightTestResult::first_failure() const {
    const ExpectationResult* first = nullptr;
    for (const ExpectationResult& one : expectations)
        if (one.is_judged && !one.holds && (first == nullptr || one.failed_s < first->failed_s)) first = &one;
    return first;
}

DisplaySession& TestDisplay::session_for(const PictureOptions& picture, bool is_generated) {
    const std::string key = picture.design + "\n" + picture.device + "\n" + picture.aircraft + "\n" + picture.terrain + "\n" +
                            picture.scene + "\n" + (is_generated ? "generated" : "recorded");
    if (session_ != nullptr && key == key_) return *session_;
    session_.reset();
    session_ = std::make_unique<DisplaySession>(picture, is_generated);
    key_ = key;
    return *session_;
}

FlightTestResult fly_flight_test(const FlightTest& test, TestDisplay& display, const FlyTestSettings& settings) {
    const PlayerFiles files = test_input_files(test, settings.folder);
    DisplaySession& session = display.session_for(test.picture, test.has_steps || is_generated_flight(files.log));
    FlightPlayer player(files, session.display(), nullptr, test_index_policy());
    require_within_input(test, (player.last() - player.first()).to_seconds(), {session.device().frame_rate_hz});
    return TestFlight(test, session, player, settings).fly();
}

WatchedFlight watch_flight(const FlightTest& test, TestDisplay& display, const FlyTestSettings& settings,
                           const WatchedTimes& times, const FrameWatcher& watcher) {
    const PlayerFiles files = test_input_files(test, settings.folder);
    DisplaySession& session = display.session_for(test.picture, test.has_steps || is_generated_flight(files.log));
    FlightPlayer player(files, session.display(), nullptr, test_index_policy());
    return TestFlight(test, session, player, settings).watch(times, watcher);
}

}  // namespace tedavis::host_sim
