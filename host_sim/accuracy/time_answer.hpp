/// The answer to a budget of time, with a margin that comes from what was measured.
///
/// Half of all runs take longer than a level's median, so a median within the budget promises little. A level answers a budget if
/// what 95 of 100 runs of it took fits, after two factors of the same measurement: the noise, by which medians of the same level
/// differ between the odd and the even rounds, and how much longer the dearest moment of the flight takes than the slowest place
/// at which all levels were measured. The second one is known of knobs with moments, and is 1 for others.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

/// A time of a frame that users ask for.
struct FrameBudget {
    double ms;
    const char* name;
};
inline constexpr std::array<FrameBudget, 5> kFrameBudgets = {{{1000.0 / 120, "120 frames/s"},
                                                              {12, "12 ms"},
                                                              {1000.0 / 60, "60 frames/s"},
                                                              {1000.0 / 30, "30 frames/s"},
                                                              {100, "10 frames/s"}}};

/// True where a budget is one of a frame, which is a sample of this knob; for other knobs it is one of all samples together.
[[nodiscard]] bool is_of_frames(const MeasuredKnob& knob);

/// What a level needs of a budget.
struct TimeNeed {
    double spread_ms = 0;  ///< what 95 of 100 runs took, of frames those of the slowest sample
    double margin = 0;     ///< 0 or more: (1 + noise) * dearest - 1

    [[nodiscard]] double needed_ms() const { return spread_ms * (1 + margin); }
};
[[nodiscard]] TimeNeed time_need(const MeasuredKnob& knob, const MeasuredLevel& level);

struct TimeAnswer {
    const MeasuredLevel* level = nullptr;  ///< of the knob, which must outlive it
    TimeNeed need;
    double expected_share = 0;  ///< of runs that keep to the budget, at the least: 0.95, or 0.99 where so many fit
};
/// The level on offer with the smallest trusted error that needs no more than the budget; nothing where none does.
[[nodiscard]] std::optional<TimeAnswer> answer_within(const MeasuredKnob& knob, double budget_ms);

/// The level on offer that needs least. The knob has a level on offer, as all have.
[[nodiscard]] const MeasuredLevel& least_needing(const MeasuredKnob& knob);

/// "95 of 100 frames of the slowest measured place took at most 8 ms; with a margin of 32 % (...) that is 10.6 ms".
[[nodiscard]] std::string need_words(const MeasuredKnob& knob, const TimeNeed& need);

/// ", so at least 95 of 100 are expected to keep to it".
[[nodiscard]] std::string share_words(const TimeAnswer& answer);

}  // namespace tedavis::host_sim
