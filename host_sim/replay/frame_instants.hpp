/// The instants at which a replay draws: whole steps from the log's start, from .. to, both ends included; or about so many as
/// the options spread over that time. Of a flight in parts each one has steps from its own start, so that even a part that is
/// shorter than a step has an instant. Events may have instants of their own beside them.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/time_range.hpp"

namespace tedavis::host_sim {

class FrameInstants {
public:
    /// `first` .. `last`: extent of the log. Throws UserError for times outside it, a `to` before `from` and bad steps.
    /// `parts`: to draw of the flight, in place of what the options say, which they lie within; empty: all that the options ask
    /// for.
    FrameInstants(const ReplayOptions& options, base::Time first, base::Time last, double rate_hz, const TimeRanges& parts = {});

    /// Adds the device's first frame at or after each of these times, where it lies in a part and is no instant yet.
    void add(const std::vector<base::Time>& events);

    [[nodiscard]] std::uint64_t count() const { return listed_.empty() ? steps_.count : listed_.size(); }
    /// The device's first frame at or after a time.
    [[nodiscard]] base::Time frame_at_or_after(base::Time time) const;
    /// In the order of the run: backwards for a negative step.
    [[nodiscard]] base::Time at(std::uint64_t n) const { return in_order_of_time(backwards_ ? count() - 1 - n : n); }
    /// A part of a run whose start is a whole step has the instants of the whole run, to the nanosecond.
    [[nodiscard]] base::Time in_order_of_time(std::uint64_t n) const {
        return listed_.empty() ? step_at(steps_, n) : listed_[static_cast<std::size_t>(n)];
    }
    /// The earliest and the latest one.
    [[nodiscard]] base::Time earliest() const { return in_order_of_time(0); }
    [[nodiscard]] base::Time latest() const { return in_order_of_time(count() - 1); }
    /// From the first instant of each part to its end.
    [[nodiscard]] const TimeRanges& parts() const { return parts_; }
    [[nodiscard]] bool backwards() const { return backwards_; }
    /// Between two of them; at events it may be less, and between two parts it is more.
    [[nodiscard]] base::Duration step() const { return base::Duration::from_seconds(step_s_); }

private:
    /// Seconds since the log's first instant.
    struct Part {
        double from_s = 0, to_s = 0;
    };
    /// Even, over one part.
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
    std::vector<base::Time> listed_;  ///< all of them in order of time, where there are several parts or events
};

}  // namespace tedavis::host_sim
