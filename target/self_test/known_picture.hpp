/// Checks the picture of the self-test's flight: sky above, terrain below the correct skyline, symbology on top.
///
/// Tolerances allow for the rounding and antialiasing of other drivers; any missing, misplaced or wrong part exceeds them by
/// far. The numbers hold for 640 x 480 with design `default` on device `es2-small`.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

inline constexpr std::uint32_t kKnownPictureWidth = 640;
inline constexpr std::uint32_t kKnownPictureHeight = 480;

/// `pixels` are RGBA8, bottom row first, of exactly the size above.
void check_known_picture(base::Span<const std::uint8_t> pixels, SelfTestReport& report);

}  // namespace tedavis::target
