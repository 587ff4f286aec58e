#include "platform/egl_kms/flip_clock.hpp"

namespace tedavis::platform {
namespace {

/// Two flips may fall into one vertical blanking where one of them is a mode set; more do not.
constexpr std::uint32_t kRepeatsWithoutVblank = 3;

}  // namespace

FlipClock::FlipClock(std::uint32_t refresh_mhz)
    : late_after_(refresh_mhz == 0 ? base::Duration{} : base::Duration{1'500'000'000'000 / refresh_mhz}) {}

bool FlipClock::flipped(const FlipEvent& event) {
    if (has_sequence_ && event.sequence != sequence_) {
        paced_by_ = FlipPacing::vblank;
        repeats_ = 0;
    } else if (has_sequence_ && ++repeats_ >= kRepeatsWithoutVblank) {
        paced_by_ = FlipPacing::timer;
    }
    has_sequence_ = true;
    sequence_ = event.sequence;
    return late_after_.ns > 0 && event.time - queued_at_ > late_after_;
}

}  // namespace tedavis::platform
