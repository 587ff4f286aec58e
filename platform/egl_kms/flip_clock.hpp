/// Judges the flips of a screen: do they come with its vertical blanking, and do they come in time?
///
/// Drivers of virtual screens confirm a flip at once and count nothing (sequence 0 for ever): there the program's own timer paces
/// the frames. Other drivers count vertical blankings.
///
/// Pure; time is an argument. Memory  none.
#pragma once

#include <cstdint>

#include "platform/egl_kms/screen_settings.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::platform {

/// A flip that the screen confirmed.
struct FlipEvent {
    std::uint32_t sequence = 0;  ///< of vertical blankings, wraps around; 0 for ever where the driver counts none
    base::Time time;             ///< of the monotonic clock
};

class FlipClock {
public:
    /// `refresh_mhz`: thousandths of a hertz; 0: not known, and no flip is late.
    explicit FlipClock(std::uint32_t refresh_mhz);

    void queued(base::Time now) { queued_at_ = now; }
    /// The flip that was queued last is done. Returns true where it came more than one and a half periods after that.
    [[nodiscard]] bool flipped(const FlipEvent& event);

    [[nodiscard]] FlipPacing paced_by() const { return paced_by_; }

private:
    base::Duration late_after_;  ///< 0: never
    base::Time queued_at_;
    FlipPacing paced_by_ = FlipPacing::timer;
    bool has_sequence_ = false;
    std::uint32_t sequence_ = 0;
    std::uint32_t repeats_ = 0;  ///< flips in a row whose sequence did not advance
};

}  // namespace tedavis::platform
