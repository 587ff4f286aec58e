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

struct ScreenFault {
    base::Error error;
    /// True where the card or the screen is not there, which time may mend: a driver that comes late, a screen that is switched
    /// on. False where the settings ask for what this machine will not have.
    bool may_come = false;
};

/// `width_px` x `height_px` is the picture of the board: the mode must have that size. Without a named card the first one with a
/// connected connector serves, without a named connector its first connected one. Of a size without a refresh rate the screen's
/// preferred mode serves, else the first one listed. The CRTC is the one that drives the connector already, else one that
/// drives no other connected screen.
[[nodiscard]] base::Result<ScreenChoice, ScreenFault> choose_screen(const ScreenInventory& inventory,
                                                                    const ScreenSettings& settings, std::uint32_t width_px,
                                                                    std::uint32_t height_px);

/// Returns "/dev/dri/card0 (virtio_gpu)".
[[nodiscard]] base::FixedString<300> card_text(const ScreenCard& card);
/// Returns "HDMI-A-1 (connected), DSI-1 (not connected)"; what does not fit is "...".
[[nodiscard]] base::FixedString<511> connectors_text(const ScreenCard& card);
/// Returns "1024x768@60, 800x600@60"; what does not fit is "...".
[[nodiscard]] base::FixedString<511> modes_text(const ScreenConnector& connector);
/// The sentence about a card that does not serve.
[[nodiscard]] base::Error card_error(const ScreenCard& card);

}  // namespace tedavis::platform
