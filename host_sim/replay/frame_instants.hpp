/// The instants at which a replay draws: whole steps from the log's start, from .. to, both ends included.
#pragma once

#include <cstdint>

#include "host_sim/options/replay_options.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

class FrameInstants {
public:
    /// `first` .. `last`: extent of the log. Throws UserError for times outside it, a `to` before `from` and bad steps.
    FrameInstants(const ReplayOptions& options, base::Time first, base::Time last, double rate_hz);

    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// In the order of the run: backwards for a negative step.
    [[nodiscard]] base::Time at(std::uint64_t n) const { return in_order_of_time(backwards_ ? count_ - 1 - n : n); }
    /// A part of a run whose start is a whole step has the instants of the whole run, to the nanosecond.
    [[nodiscard]] base::Time in_order_of_time(std::uint64_t n) const;
    [[nodiscard]] bool backwards() const { return backwards_; }
    [[nodiscard]] base::Duration step() const { return base::Duration::from_seconds(step_s_); }

private:
    base::Time origin_;
    double offset_s_ = 0;  ///< 0 where the start is a whole step
    double step_s_ = 0;
    std::uint64_t steps_before_ = 0;
    std::uint64_t count_ = 0;
    bool backwards_ = false;
};

}  // namespace tedavis::host_sim
