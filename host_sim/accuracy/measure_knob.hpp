/// Measures a knob: errors once, since they are the same in every run, and times in interleaved rounds.
///
/// In each round every level processes all samples once. The order of the levels changes from round to round, so that a temporary
/// load on the machine slows all levels. The odd and the even rounds form an A/A test: the difference between them is noise.
/// Each round ends with the knob's moments, at the level in the middle.
#pragma once

#include <functional>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

struct MeasuringPlan {
    static constexpr std::size_t kMinRounds = 6;

    std::size_t rounds = 11;  ///< kMinRounds or more
    double most_s = 0;        ///< after kMinRounds rounds, no round begins later than this time; 0: no limit
    /// Returns the milliseconds of a clock that never runs back.
    std::function<double()> clock_ms;
    /// Called before each round with the number of rounds that are done, and with 0 while errors are determined. It may throw,
    /// which ends the measurement.
    std::function<void(std::size_t done, std::size_t total)> progress;
};

/// The level's name, errors, memory and build time; without times.
[[nodiscard]] MeasuredLevel level_errors(Knob& knob, std::size_t number);

[[nodiscard]] MeasuredKnob measure_knob(Knob& knob, const MeasuringPlan& plan);

}  // namespace tedavis::host_sim
