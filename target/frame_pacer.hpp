/// Tells when the next frame is due. Due times form an even grid from the start, so a late frame does not delay the following
/// ones.
///
/// Time is an argument; no clock is read. Due times that passed without a frame are counted and not made up for.
#pragma once

#include <cstdint>

#include "render_core/base/time.hpp"

namespace tedavis::target {

class FramePacer {
public:
    /// `rate_hz` 1 to 1000.
    FramePacer(double rate_hz, base::Time start);

    /// Returns the first due time after the last one returned that still lies ahead of `now`.
    [[nodiscard]] base::Time next(base::Time now);
    [[nodiscard]] std::uint64_t missed() const { return missed_; }

private:
    [[nodiscard]] base::Time at(std::int64_t turn) const;

    double period_s_;
    base::Time start_;
    std::int64_t turn_ = 0;  // index of the due time returned last
    std::uint64_t missed_ = 0;
};

}  // namespace tedavis::target
