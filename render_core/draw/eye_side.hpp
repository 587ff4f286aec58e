/// The two eyes of a stereo picture. Pure; any thread.
#pragma once

#include <cstdint>

namespace tedavis::draw {

enum class EyeSide : std::uint8_t { left, right };
inline constexpr EyeSide kEyeSides[] = {EyeSide::left, EyeSide::right};

/// Returns where the screen begins in an eye's picture, in pixels from its left edge. `shift_px` is the shift of each eye's
/// picture towards its own side, -margin..margin.
[[nodiscard]] std::int32_t screen_begins_px(std::uint32_t margin_px, EyeSide side, std::int32_t shift_px);

}  // namespace tedavis::draw
