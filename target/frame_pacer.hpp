/// When the next frame is due: an even grid from the start, on which a late frame does not make the following ones late.
///
/// Plain arithmetic; time is an argument. Frames whose turn passed are missed, counted, and not made up for.
#pragma once

#include <cstdint>

#include "render_core/base/time.hpp"

namespace tedavis::target {

class FramePacer {
public:
    /// `rate_hz` 1 to 1000.
    FramePacer(double rate_hz, base::Time start);

    /// The first instant of the grid after the last one given out that still lies ahead of `now`.
    [[nodiscard]] base::Time next(base::Time now);
    [[nodiscard]] std::uint64_t missed() const { return missed_; }

private:
    [[nodiscard]] base::Time at(std::int64_t turn) const;

    double period_s_;
    base::Time start_;
    std::int64_t turn_ = 0;  // last one given out
    std::uint64_t missed_ = 0;
};

}  // namespace tedavis::target
