/// User input to the window, as plain data.
#pragma once

#include <cstdint>
#include <type_traits>

namespace tedavis::platform {

/// The keys that the simulator uses; letters and digits have their character in `character`.
enum class Key : std::uint8_t {
    other,
    character,
    escape,
    enter,
    space,
    backspace,
    tab,
    left,
    right,
    up,
    down,
    page_up,
    page_down,
    home,
    end
};

enum class WindowEventKind : std::uint8_t { closed, key_down, key_up, mouse_move, mouse_down, mouse_up, mouse_wheel };

enum class MouseButton : std::uint8_t { none, left, middle, right };

struct WindowEvent {
    WindowEventKind kind = WindowEventKind::closed;
    Key key = Key::other;
    char character = '\0';  ///< of Key::character: 'a'..'z', '0'..'9' and ASCII signs, unshifted, lower case
    bool shift = false;
    bool control = false;
    bool repeat = false;  ///< repeated by a held key
    MouseButton button = MouseButton::none;
    std::int32_t x_px = 0, y_px = 0;    ///< pointer, from the upper left corner
    std::int32_t dx_px = 0, dy_px = 0;  ///< mouse_move: since the last event; mouse_wheel: notches, positive up and right
};
static_assert(std::is_trivially_copyable_v<WindowEvent>);

}  // namespace tedavis::platform
