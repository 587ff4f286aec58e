/// Tells when the next frame is due: on an even grid of the device's rate, or, on a screen that counts its vertical blankings, so
/// that frames are shown evenly many blankings apart, at the device's rate or less.
///
/// By the grid a late frame does not delay the following ones. By blankings a frame begins as late as the longest drawing time of
/// the last frames allows, with some reserve, because it then shows the newest data. In both cases frames that were not shown at
/// their time are counted and not made up for.
///
/// Time is an argument; no clock is read.
#pragma once

#include <cstdint>

#include "render_core/base/time.hpp"

namespace tedavis::target {

/// What a screen has said of the frame that it shows.
struct ScreenBlanking {
    base::Time shown_at;     ///< the blanking since which it shows it
    base::Duration refresh;  ///< from one blanking to the next, more than 0
};

class FramePacer {
public:
    /// `rate_hz` 1 to 1000.
    FramePacer(double rate_hz, base::Time start);

    /// Returns the first due time of the grid after the last one returned that still lies ahead of `now`.
    [[nodiscard]] base::Time next(base::Time now);
    /// Returns when to begin the next frame after one that was shown at a blanking; `work` is how long that one took until it was
    /// complete, without waiting for the screen. The grid begins anew there.
    [[nodiscard]] base::Time next_after(const ScreenBlanking& blanking, base::Duration work);
    /// The frame that is drawn must not go to the screen before: it would be shown a blanking too early.
    [[nodiscard]] base::Time earliest_flip() const { return earliest_flip_; }
    [[nodiscard]] std::uint64_t missed() const { return missed_; }

private:
    [[nodiscard]] base::Time at(std::int64_t turn) const;
    [[nodiscard]] std::int64_t blankings_apart(base::Duration refresh) const;
    void count_missed(const ScreenBlanking& blanking, std::int64_t apart);

    double period_s_;
    base::Time start_;
    std::int64_t turn_ = 0;  // index of the due time returned last
    std::uint64_t missed_ = 0;
    base::Time earliest_flip_;
    base::Duration longest_work_;  // of the last frames
    base::Time shown_at_;          // of the frame before
    bool follows_blankings_ = false;
};

}  // namespace tedavis::target
