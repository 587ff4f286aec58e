/// Decides which connector of which card shows the display, in which mode.
///
/// Pure: reads lists, asks no device. Thread  any. Memory  none. Failure  one sentence that says what is wrong, where, and what
/// to do, and that lists what is there.
#pragma once

#include <cstdint>

#include "platform/egl_kms/screen_inventory.hpp"
#include "platform/egl_kms/screen_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

struct ScreenChoice {
    std::size_t card = 0;       ///< in the inventory
    std::size_t connector = 0;  ///< in the card
    ScreenMode mode;
    std::uint32_t crtc_id = 0;
    std::uint32_t crtc_index = 0;  ///< in the card
};

/// `width_px` x `height_px` is the picture of the board: the mode must have that size. Without a named card the first one with a
/// connected connector serves, without a named connector its first connected one. Of a size without a refresh rate the screen's
/// preferred mode serves, else the first one listed. The CRTC is the one that drives the connector already, else one that
/// drives no other connected screen.
[[nodiscard]] base::Result<ScreenChoice, base::Error> choose_screen(const ScreenInventory& inventory,
                                                                    const ScreenSettings& settings, std::uint32_t width_px,
                                                                    std::uint32_t height_px);

}  // namespace tedavis::platform
