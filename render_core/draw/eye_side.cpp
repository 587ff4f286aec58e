#include "render_core/draw/eye_side.hpp"

#include <algorithm>

namespace tedavis::draw {

std::int32_t screen_begins_px(std::uint32_t margin_px, EyeSide side, std::int32_t shift_px) {
    const auto margin = static_cast<std::int32_t>(margin_px);
    const std::int32_t shift = std::clamp(shift_px, -margin, margin);
    return side == EyeSide::left ? margin + shift : margin - shift;
}

}  // namespace tedavis::draw
