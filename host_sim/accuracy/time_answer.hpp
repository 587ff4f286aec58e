/// The most accurate level within a time budget, with a margin that is derived from the measurements.
///
/// Half of all runs take longer than a level's median, so a median within the budget guarantees little. A level is within a
/// budget if the time that 95 of 100 runs do not exceed is, after two factors: the noise, by which medians of the same level
/// differ between the odd and the even rounds, and the ratio of the slowest moment of the flight to the slowest place at which
/// all levels were measured. The second factor is measured for knobs with moments, and is 1 for others.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

/// A common time budget of a frame.
struct FrameBudget {
    double ms;
    const char* name;
};
inline constexpr std::array<FrameBudget, 5> kFrameBudgets = {{{1000.0 / 120, "120 frames/s"},
                                                              {12, "12 ms"},
                                                              {1000.0 / 60, "60 frames/s"},
                                                              {1000.0 / 30, "30 frames/s"},
                                                              {100, "10 frames/s"}}};

/// True if a sample of this knob is a frame, so that a budget is the time of one sample; for other knobs it is the time of all
/// samples together.
[[nodiscard]] bool is_of_frames(const MeasuredKnob& knob);

/// The share of a budget that a level needs.
struct TimeNeed {
    double spread_ms = 0;  ///< time that 95 of 100 runs do not exceed; if samples are frames, runs of the slowest sample
    double margin = 0;     ///< 0 or more: (1 + noise) * dearest - 1

    [[nodiscard]] double needed_ms() const { return spread_ms * (1 + margin); }
};
[[nodiscard]] TimeNeed time_need(const MeasuredKnob& knob, const MeasuredLevel& level);

struct TimeAnswer {
    const MeasuredLevel* level = nullptr;  ///< a level of the knob, which must outlive this
    TimeNeed need;
    double expected_share = 0;  ///< least share of runs within the budget: 0.95, or 0.99 where so many are
};
/// The offered level with the smallest trusted error that needs no more than the budget; nothing where there is none.
[[nodiscard]] std::optional<TimeAnswer> answer_within(const MeasuredKnob& knob, double budget_ms);

/// The offered level that needs the least time. Every knob offers at least one.
[[nodiscard]] const MeasuredLevel& least_needing(const MeasuredKnob& knob);

/// "95 of 100 frames of the slowest measured place took at most 8 ms; with a margin of 32 % (...) that is 10.6 ms".
[[nodiscard]] std::string need_words(const MeasuredKnob& knob, const TimeNeed& need);

/// ", so at least 95 of 100 are expected to keep to it".
[[nodiscard]] std::string share_words(const TimeAnswer& answer);

}  // namespace tedavis::host_sim
