/// The instants at which a replay draws: whole steps from the log's start, from .. to, both ends included; or about so many as
/// the options spread over that time. Events may have instants of their own beside them.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/options/replay_options.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

class FrameInstants {
public:
    /// `first` .. `last`: extent of the log. Throws UserError for times outside it, a `to` before `from` and bad steps.
    FrameInstants(const ReplayOptions& options, base::Time first, base::Time last, double rate_hz);

    /// Adds the device's first frame at or after each of these times, where it lies between from and to and is no instant yet.
    void add(const std::vector<base::Time>& events);

    [[nodiscard]] std::uint64_t count() const { return listed_.empty() ? count_ : listed_.size(); }
    /// In the order of the run: backwards for a negative step.
    [[nodiscard]] base::Time at(std::uint64_t n) const { return in_order_of_time(backwards_ ? count() - 1 - n : n); }
    /// A part of a run whose start is a whole step has the instants of the whole run, to the nanosecond.
    [[nodiscard]] base::Time in_order_of_time(std::uint64_t n) const {
        return listed_.empty() ? step_at(n) : listed_[static_cast<std::size_t>(n)];
    }
    /// The earliest and the latest one.
    [[nodiscard]] base::Time earliest() const { return in_order_of_time(0); }
    [[nodiscard]] base::Time latest() const { return in_order_of_time(count() - 1); }
    [[nodiscard]] bool backwards() const { return backwards_; }
    /// Between two of them; at events it may be less.
    [[nodiscard]] base::Duration step() const { return base::Duration::from_seconds(step_s_); }

private:
    void set_steps(double from_s, double to_s);
    void spread(std::uint64_t frames, double from_s, double to_s);
    [[nodiscard]] base::Time step_at(std::uint64_t n) const;
    [[nodiscard]] base::Time frame_at_or_after(base::Time time) const;

    base::Time origin_, end_;
    double rate_hz_ = 0;
    double offset_s_ = 0;  ///< 0 where the start is a whole step
    double step_s_ = 0;
    std::uint64_t steps_before_ = 0;
    std::uint64_t count_ = 0;
    bool backwards_ = false;
    std::vector<base::Time> listed_;  ///< all of them in order of time, where there are events
};

}  // namespace tedavis::host_sim
