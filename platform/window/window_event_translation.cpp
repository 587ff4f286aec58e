#include "platform/window/window_event_translation.hpp"

#if defined(TEDAVIS_HAVE_SDL2)

#include <SDL.h>

namespace tedavis::platform {
namespace {

struct KeyPair {
    SDL_Keycode code;
    Key key;
};
constexpr KeyPair kKeys[] = {{SDLK_ESCAPE, Key::escape},
                             {SDLK_RETURN, Key::enter},
                             {SDLK_SPACE, Key::space},
                             {SDLK_TAB, Key::tab},
                             {SDLK_BACKSPACE, Key::backspace},
                             {SDLK_LEFT, Key::left},
                             {SDLK_RIGHT, Key::right},
                             {SDLK_UP, Key::up},
                             {SDLK_DOWN, Key::down},
                             {SDLK_PAGEUP, Key::page_up},
                             {SDLK_PAGEDOWN, Key::page_down},
                             {SDLK_HOME, Key::home},
                             {SDLK_END, Key::end}};

void translate_key(const SDL_KeyboardEvent& from, WindowEvent& to) {
    to.kind = from.type == SDL_KEYDOWN ? WindowEventKind::key_down : WindowEventKind::key_up;
    to.shift = (from.keysym.mod & KMOD_SHIFT) != 0;
    to.control = (from.keysym.mod & KMOD_CTRL) != 0;
    to.repeat = from.repeat != 0;
    const SDL_Keycode code = from.keysym.sym;
    for (const KeyPair& pair : kKeys)
        if (pair.code == code) to.key = pair.key;
    if (to.key == Key::other && code > ' ' && code < 127) {  // SDL's codes of these keys are their ASCII characters
        to.key = Key::character;
        to.character = static_cast<char>(code);
    }
}

MouseButton translate_button(std::uint8_t button) {
    switch (button) {
        case SDL_BUTTON_LEFT: return MouseButton::left;
        case SDL_BUTTON_MIDDLE: return MouseButton::middle;
        case SDL_BUTTON_RIGHT: return MouseButton::right;
        default: return MouseButton::none;
    }
}

void translate_motion(const SDL_MouseMotionEvent& from, WindowEvent& to) {
    to.kind = WindowEventKind::mouse_move;
    to.x_px = from.x;
    to.y_px = from.y;
    to.dx_px = from.xrel;
    to.dy_px = from.yrel;
    to.button = (from.state & SDL_BUTTON_LMASK) != 0   ? MouseButton::left
                : (from.state & SDL_BUTTON_RMASK) != 0 ? MouseButton::right
                : (from.state & SDL_BUTTON_MMASK) != 0 ? MouseButton::middle
                                                       : MouseButton::none;
}

void translate_click(const SDL_MouseButtonEvent& from, WindowEvent& to) {
    to.kind = from.type == SDL_MOUSEBUTTONDOWN ? WindowEventKind::mouse_down : WindowEventKind::mouse_up;
    to.x_px = from.x;
    to.y_px = from.y;
    to.button = translate_button(from.button);
}

void translate_wheel(const SDL_MouseWheelEvent& from, WindowEvent& to) {
    const int sign = from.direction == SDL_MOUSEWHEEL_FLIPPED ? -1 : 1;
    to.kind = WindowEventKind::mouse_wheel;
    to.dx_px = sign * from.x;
    to.dy_px = sign * from.y;
}

}  // namespace

bool translate_event(const SDL_Event& from, WindowEvent& to) {
    to = WindowEvent();
    switch (from.type) {
        case SDL_QUIT: return true;
        case SDL_KEYDOWN:
        case SDL_KEYUP: translate_key(from.key, to); return true;
        case SDL_MOUSEMOTION: translate_motion(from.motion, to); return true;
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP: translate_click(from.button, to); return true;
        case SDL_MOUSEWHEEL: translate_wheel(from.wheel, to); return true;
        default: return false;
    }
}

}  // namespace tedavis::platform

#endif
