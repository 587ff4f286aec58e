/// What the picture of the self-test's flight must show: sky above, terrain below the right skyline, symbology on top.
///
/// Tolerances are wide enough for another driver's rounding and antialiasing, and far narrower than what any missing,
/// misplaced or mistaken part would change. The numbers hold for 640 x 480 with design `default` on device `es2-small`.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

inline constexpr std::uint32_t kKnownPictureWidth = 640;
inline constexpr std::uint32_t kKnownPictureHeight = 480;

/// `pixels` are RGBA8, bottom row first, of exactly this size.
void check_known_picture(base::Span<const std::uint8_t> pixels, SelfTestReport& report);

}  // namespace tedavis::target
