#include "host_sim/flight_test/fly_on_board.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>

#include "host_sim/flight_test/board_records.hpp"
#include "host_sim/flight_test/input_logs.hpp"
#include "host_sim/flight_test/read_conditions.hpp"
#include "host_sim/flight_test/timed_input.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr base::Duration kBeforeInput = base::Duration::milliseconds(500);  // in which the panel's first levels settle
constexpr base::Duration kShortestTurn = base::Duration::milliseconds(5);   // what is due within it is sent together, at its end
constexpr base::Duration kLongestTurn = base::Duration::milliseconds(100);  // until Ctrl-C is seen
constexpr base::Duration kKnownFor =
    base::Duration::seconds(10);  // all signals that are known for so long must be lost before a test begins
constexpr base::Duration kAskedFor = base::Duration::seconds(30);  // those that the test asks for, too

constexpr base::Time kNever{std::numeric_limits<std::int64_t>::max()};
constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

std::string text_of_seconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", seconds);
    return text;
}

/// An expectation with the conditions that can be answered. What must not hold before it is reached is known with all of its
/// conditions only: without one of them nothing is left of it.
template <class IsAnswered>
Expectation answerable(const Expectation& expectation, IsAnswered is_answered) {
    Expectation kept = expectation;
    const auto answered = std::stable_partition(kept.conditions.begin(), kept.conditions.end(), is_answered);
    const bool is_whole = answered == kept.conditions.end();
    kept.conditions.erase(is_whole || kept.kind != WindowKind::within ? answered : kept.conditions.begin(),
                          kept.conditions.end());
    return kept;
}

/// The panel is at rest before a test and behind it, however that ends.
class PanelAtRest {
public:
    PanelAtRest(BoardPort& port, const bus::SwitchConfig& panel) : port_(port), panel_(panel) {
        if (port_.has_panel()) set_lines(resting_levels(panel_));
    }
    /// What ended the test has been said already; a panel that is gone says nothing new.
    ~PanelAtRest() {
        try {
            if (port_.has_panel()) set_lines(resting_levels(panel_));
        } catch (const std::exception&) {
        }
    }
    PanelAtRest(const PanelAtRest&) = delete;
    PanelAtRest& operator=(const PanelAtRest&) = delete;

    void set_lines(std::uint32_t levels) {
        for (std::size_t line = 0; line < panel_.lines.size(); ++line) port_.set_line(line, (levels >> line & 1u) != 0);
    }

private:
    BoardPort& port_;
    const bus::SwitchConfig& panel_;
};

class BoardFlight {
public:
    BoardFlight(const FlightTest& test, BoardPort& port, const BoardFlightSettings& settings)
        : test_(test),
          port_(port),
          settings_(settings),
          input_(read_timed_input(test_input_files(test, settings.folder), test.panel)),
          records_(port, settings.display, settings.is_interrupted) {
        require_within_input(test, input_.end_s(), {});
        for (const Expectation& one : test.expectations) {
            end_s_ = std::max(end_s_, one.to_s);
            expectations_.push_back(answerable(one, &is_in_board_record));
            for (const FrameCondition& condition : expectations_.back().conditions)
                if (condition.signal) is_asked_[static_cast<std::size_t>(*condition.signal)] = true;
        }
        if (input_.throws_panel && !port.has_panel())
            throw UserError(
                "throws switches, and there is no panel to throw; say --panel-lines with the folder of its gpio-sim lines");
    }

    FlightTestResult fly() {
        PanelAtRest panel(port_, test_.panel);
        begin_judging(await_neutral());
        if (input_.throws_panel) panel.set_lines(input_.first_levels);
        begin_ = port_.now() + kBeforeInput;
        while (!is_done()) {
            const base::Time due = send_due(), now = port_.now();
            take_record(std::clamp(due, now + kShortestTurn, now + kLongestTurn));
            if (settings_.told) settings_.told(std::clamp((port_.now() - begin_).to_seconds(), 0.0, end_s_), end_s_);
        }
        return results();
    }

private:
    [[nodiscard]] bool is_done() const {
        bool is_settled = true;
        for (std::size_t n = 0; n < judges_.size(); ++n) is_settled = is_settled && (!is_judged(n) || judges_[n].is_settled());
        return is_settled || passed_s_ > end_s_ + ExpectationJudge::kLatestFrame_s;
    }

    [[nodiscard]] bool is_judged(std::size_t expectation) const { return !expectations_[expectation].conditions.empty(); }

    /// Nothing is judged by what an earlier test has sent.
    void begin_judging(const ObservedFrame& neutral) {
        const auto is_answered = [&](const FrameCondition& condition) {
            return !condition.signal || !is_known(neutral, static_cast<std::size_t>(*condition.signal));
        };
        for (Expectation& one : expectations_) one = answerable(one, is_answered);
        for (const Expectation& one : expectations_) judges_.emplace_back(one, FrameTimes{});
    }

    [[nodiscard]] static bool is_known(const ObservedFrame& seen, std::size_t signal) {
        const base::SignalState state = seen.record.signals[signal];
        return state == base::SignalState::valid || state == base::SignalState::stale;
    }

    /// What keeps the display from knowing nothing; empty: nothing does.
    [[nodiscard]] std::string unrest(const ObservedFrame& seen) const {
        const flight::PhaseStatus& phase = seen.record.phase;
        const bool is_stated = phase.source != flight::PhaseSource::none && phase.source != flight::PhaseSource::switches;
        const bool is_thrown = phase.source == flight::PhaseSource::switches && !input_.throws_panel;
        if (is_stated || is_thrown) return "phase " + phase_text(phase.phase) + " of source " + flight::to_string(phase.source);
        for (std::size_t n = 0; n < flight::kSignalCount; ++n) {
            if (is_known(seen, n) && !(test_.bus.limits[n].lost > (is_asked_[n] ? kAskedFor : kKnownFor)))
                return std::string("signal ") + flight::to_string(static_cast<flight::Signal>(n)) + " " +
                       base::to_string(seen.record.signals[n]);
        }
        return {};
    }

    /// All that a record says of the board that it comes from.
    void require_design(const display::FrameRecord& record) const {
        const std::string shown(record.design.view());
        const std::vector<std::string>& designs = settings_.designs;
        if (designs.empty() || std::find(designs.begin(), designs.end(), shown) != designs.end()) return;
        throw UserError(settings_.display + ": the display shows the design '" + shown +
                        "', which the board file does not have; say --board with the file that it was started with");
    }

    /// Returns the first frame in which the display knows nothing that could be judged.
    ObservedFrame await_neutral() {
        const base::Time silent_since = port_.now();
        for (;;) {
            const auto record = records_.next(port_.now() + kLongestTurn);
            if (!record) continue;
            const double silent_s = record->monotonic_s - (silent_since - base::Time{}).to_seconds();
            if (silent_s < kSilence.to_seconds()) continue;
            require_on_screen(*record, settings_.display);
            require_design(record->seen.record);
            const std::string why = unrest(record->seen);
            if (why.empty()) return record->seen;
            if (silent_s > (kSilence + kLongestUnrest).to_seconds())
                throw UserError(settings_.display + ": after " + text_of_seconds(silent_s) +
                                " of silence the display still has " + why +
                                "; end what else sends on its bus, and set its panel to leave the phase to the bus");
        }
    }

    /// Frames and edges in the order of their times. Returns when the next thing is due.
    base::Time send_due() {
        const base::Time now = port_.now();
        for (;;) {
            const base::Time frame = next_frame_ < input_.frames.size() ? due(input_.frames[next_frame_].time) : kNever;
            const base::Time edge = next_edge_ < input_.edges.size() ? due(input_.edges[next_edge_].time) : kNever;
            const base::Time next = std::min(frame, edge);
            if (next > now) return next;
            if (frame <= edge)
                port_.send(input_.frames[next_frame_++]);
            else
                throw_switch(input_.edges[next_edge_++]);
            record_delay(next);
        }
    }

    void throw_switch(const bus::SwitchEdge& edge) { port_.set_line(edge.line, edge.level); }

    [[nodiscard]] base::Time due(base::Time of_input) const { return begin_ + (of_input - base::Time{}); }

    void record_delay(base::Time due_at) {
        const base::Duration delay = port_.now() - due_at;
        if (delay > kLongestDelay)
            throw UserError("at " + text_of_seconds((due_at - begin_).to_seconds()) + " this machine was " +
                            text_of_seconds(delay.to_seconds()) + " late with the input; end other programs and fly it again");
    }

    void take_record(base::Time until) {
        std::optional<BoardRecord> record = records_.next(until);
        if (!record) return;
        require_on_screen(*record, settings_.display);
        ObservedFrame& frame = record->seen;
        frame.time_s = record->monotonic_s - (begin_ - base::Time{}).to_seconds();
        record_latency(*record);
        frame.latency_frames = latency_frames_;
        frame.is_latency_to_screen = true;
        judge_frame(frame);
        passed_s_ = frame.time_s;
    }

    /// Between two messages it is that of the earlier one, but not for long.
    void record_latency(const BoardRecord& record) {
        if (record.can_to_screen_s) {
            latency_frames_ = *record.can_to_screen_s * settings_.rate_hz;
            latency_of_s_ = record.seen.time_s;
        } else if (record.seen.time_s - latency_of_s_ > ExpectationJudge::kLatestFrame_s) {
            latency_frames_ = kNotMeasured;
        }
    }

    void judge_frame(const ObservedFrame& frame) {
        ++result_.frames;
        std::optional<std::size_t> failed;
        for (std::size_t n = 0; n < judges_.size(); ++n) {
            if (!is_judged(n)) continue;
            ExpectationJudge& judge = judges_[n];
            const bool fails = judge.pass(frame.time_s) || (judge.wants(frame.time_s) && judge.take(frame));
            if (fails && !failed) failed = n;
        }
        if (!failed || !result_.record.empty()) return;
        result_.record = records_.packet();
        result_.shown = *failed;
        result_.shown_s = frame.time_s;
    }

    FlightTestResult results() {
        for (std::size_t n = 0; n < judges_.size(); ++n) {
            const std::size_t left_out = test_.expectations[n].conditions.size() - expectations_[n].conditions.size();
            ExpectationResult result = judges_[n].result();
            if (!is_judged(n)) {
                result = ExpectationResult();
                result.is_judged = false;
            }
            result.not_judged = left_out;
            result_.expectations.push_back(std::move(result));
        }
        return std::move(result_);
    }

    const FlightTest& test_;
    BoardPort& port_;
    const BoardFlightSettings& settings_;
    TimedInput input_;
    std::vector<Expectation> expectations_;  ///< as far as they can be judged
    std::vector<ExpectationJudge> judges_;
    FlightTestResult result_;
    base::Time begin_;
    std::size_t next_frame_ = 0, next_edge_ = 0;
    double end_s_ = 0, passed_s_ = -1;
    double latency_frames_ = kNotMeasured, latency_of_s_ = 0;
    std::array<bool, flight::kSignalCount> is_asked_{};  ///< signals, by an expectation
    BoardRecords records_;
};

}  // namespace

FlightTestResult fly_on_board(const FlightTest& test, BoardPort& port, const BoardFlightSettings& settings) {
    return BoardFlight(test, port, settings).fly();
}

}  // namespace tedavis::host_sim
