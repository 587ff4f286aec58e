/// Measures a knob: errors once, since they are the same in every run, and times in interleaved rounds.
///
/// In a round every level does all samples once, in an order that changes from round to round, so that what slows the machine
/// for a while slows all levels. Odd and even rounds are an A/A run: what differs between them is noise.
#pragma once

#include <functional>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

struct MeasuringPlan {
    static constexpr std::size_t kMinRounds = 6;

    std::size_t rounds = 11;  ///< kMinRounds or more
    double most_s = 0;        ///< no further round begins after that time, but for the first kMinRounds; 0: no limit
    /// Milliseconds of a clock that does not run back.
    std::function<double()> clock_ms;
    /// May throw; `done` of `total` rounds, 0 while errors are found.
    std::function<void(std::size_t done, std::size_t total)> progress;
};

[[nodiscard]] MeasuredKnob measure_knob(Knob& knob, const MeasuringPlan& plan);

}  // namespace tedavis::host_sim
