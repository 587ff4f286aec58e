/// The cards of a machine with their connectors and modes, as plain lists of fixed capacity.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::platform {

struct ScreenMode {
    std::uint32_t width_px = 0, height_px = 0;
    std::uint32_t refresh_mhz = 0;  ///< thousandths of a hertz
    std::uint16_t index = 0;        ///< in the card's own list of the connector
    bool is_preferred = false;      ///< by the screen itself
    bool is_interlaced = false;
};

struct ScreenConnector {
    base::FixedString<31> name;  ///< "HDMI-A-1"
    std::uint32_t id = 0;
    bool is_connected = false;
    std::uint32_t possible_crtcs = 0;  ///< bit n: the card's CRTC n can drive it
    std::uint32_t crtc_id = 0;         ///< that drives it now; 0: none
    base::FixedVector<ScreenMode, 96> modes;
};

enum class CardAccess : std::uint8_t {
    open,
    missing,        ///< there is no such file
    no_permission,  ///< the file may not be opened
    no_screens,     ///< a file that is no card, or a card that drives no screens (no KMS)
    failed
};

struct ScreenCard {
    base::FixedString<255> path;
    base::FixedString<31> driver;  ///< empty where the card could not be opened
    base::FixedString<31> group;   ///< that the file belongs to, where this user may not open it; empty: not known
    CardAccess access = CardAccess::failed;
    base::FixedVector<std::uint32_t, 16> crtcs;
    base::FixedVector<ScreenConnector, 12> connectors;
};

/// More cards, connectors or modes than fit are left out; the lists count them (refused()).
struct ScreenInventory {
    base::FixedVector<ScreenCard, 6> cards;
};
static_assert(std::is_trivially_copyable_v<ScreenInventory>);

}  // namespace tedavis::platform
