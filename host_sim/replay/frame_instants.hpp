/// The times at which a replay draws: whole steps from the log's start that lie in from .. to, both included; or the number of
/// frames of ReplayOptions::spread. If only parts of the flight are drawn, each part has steps from its own start, so that even a
/// part shorter than a step has one frame. Times of events may be added.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/time_range.hpp"

namespace tedavis::host_sim {

class FrameInstants {
public:
    /// `first` .. `last` is the extent of the log. `parts` are the parts of the flight to draw, all within the time that the
    /// options state; empty: all of that time. Throws UserError for times outside the log, a `to` before `from`, and bad steps.
    FrameInstants(const ReplayOptions& options, base::Time first, base::Time last, double rate_hz, const TimeRanges& parts = {});

    /// Adds the device's first frame at or after each of these times, if it lies in a part and is not listed yet.
    void add(const std::vector<base::Time>& events);

    [[nodiscard]] std::uint64_t count() const { return listed_.empty() ? steps_.count : listed_.size(); }
    /// The time of the first frame at or after `time`, at the device's frame rate from the log's start.
    [[nodiscard]] base::Time frame_at_or_after(base::Time time) const;
    /// The n-th time in the order of drawing, which is backwards for a negative step.
    [[nodiscard]] base::Time at(std::uint64_t n) const { return in_order_of_time(backwards_ ? count() - 1 - n : n); }
    /// The n-th time, ascending. If the start is a whole step, the times are equal to those of the whole run, to the nanosecond.
    [[nodiscard]] base::Time in_order_of_time(std::uint64_t n) const {
        return listed_.empty() ? step_at(steps_, n) : listed_[static_cast<std::size_t>(n)];
    }
    /// The earliest and the latest time.
    [[nodiscard]] base::Time earliest() const { return in_order_of_time(0); }
    [[nodiscard]] base::Time latest() const { return in_order_of_time(count() - 1); }
    /// Each part, from its first drawn time to its end.
    [[nodiscard]] const TimeRanges& parts() const { return parts_; }
    [[nodiscard]] bool backwards() const { return backwards_; }
    /// The time between two frames; at events it may be less, and between two parts it is more.
    [[nodiscard]] base::Duration step() const { return base::Duration::from_seconds(step_s_); }

private:
    /// Seconds since the log's first instant.
    struct Part {
        double from_s = 0, to_s = 0;
    };
    /// Even steps over one part.
    struct Steps {
        double offset_s = 0;  ///< 0 where the start is a whole step
        std::uint64_t before = 0, count = 0;
    };
    [[nodiscard]] Steps steps_of(const Part& part) const;
    void spread(std::uint64_t frames, std::vector<Part>& parts);
    void list_steps(const std::vector<Part>& parts);
    [[nodiscard]] base::Time step_at(const Steps& steps, std::uint64_t n) const;

    base::Time origin_;
    double rate_hz_ = 0;
    double step_s_ = 0;
    bool backwards_ = false;
    Steps steps_;  ///< of the only part
    TimeRanges parts_;
    std::vector<base::Time> listed_;  ///< all times, ascending, if there are several parts or events; else empty
};

}  // namespace tedavis::host_sim
