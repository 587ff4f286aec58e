#include "platform/window/window_event_translation.hpp"

#include <gtest/gtest.h>

#if defined(TEDAVIS_HAVE_SDL2)
#include <SDL.h>

namespace tedavis::platform::test_window_event_translation {
namespace {

WindowEvent translated(const SDL_Event& from) {
    WindowEvent to;
    EXPECT_TRUE(translate_event(from, to));
    return to;
}

SDL_Event key(SDL_Keycode code, std::uint16_t modifiers = 0, std::uint32_t type = SDL_KEYDOWN) {
    SDL_Event event{};
    event.type = type;
    event.key.keysym.sym = code;
    event.key.keysym.mod = modifiers;
    return event;
}

TEST(WindowEvents, LettersDigitsAndSignsCarryTheirCharacter) {
    for (char c : {'a', 'z', '0', '9', '+', '[', ','}) {
        const WindowEvent event = translated(key(c));
        EXPECT_EQ(event.kind, WindowEventKind::key_down);
        EXPECT_EQ(event.key, Key::character);
        EXPECT_EQ(event.character, c);
    }
}

TEST(WindowEvents, NamedKeysHaveNoCharacter) {
    EXPECT_EQ(translated(key(SDLK_ESCAPE)).key, Key::escape);
    EXPECT_EQ(translated(key(SDLK_SPACE)).key, Key::space);
    EXPECT_EQ(translated(key(SDLK_PAGEDOWN)).key, Key::page_down);
    EXPECT_EQ(translated(key(SDLK_LEFT)).character, '\0');
    EXPECT_EQ(translated(key(SDLK_F5)).key, Key::other);
    EXPECT_EQ(translated(key(SDLK_UP, 0, SDL_KEYUP)).kind, WindowEventKind::key_up);
}

TEST(WindowEvents, ModifiersAndRepeats) {
    EXPECT_TRUE(translated(key('s', KMOD_LSHIFT)).shift);
    EXPECT_TRUE(translated(key('s', KMOD_RCTRL)).control);
    EXPECT_FALSE(translated(key('s')).shift);
    SDL_Event held = key('s');
    held.key.repeat = 1;
    EXPECT_TRUE(translated(held).repeat);
}

TEST(WindowEvents, TheMouse) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = 10;
    event.motion.y = 20;
    event.motion.xrel = -3;
    event.motion.yrel = 4;
    event.motion.state = SDL_BUTTON_RMASK;
    const WindowEvent move = translated(event);
    EXPECT_EQ(move.kind, WindowEventKind::mouse_move);
    EXPECT_EQ(move.x_px, 10);
    EXPECT_EQ(move.dy_px, 4);
    EXPECT_EQ(move.button, MouseButton::right);

    event = SDL_Event{};
    event.type = SDL_MOUSEBUTTONUP;
    event.button.button = SDL_BUTTON_LEFT;
    event.button.x = 7;
    EXPECT_EQ(translated(event).kind, WindowEventKind::mouse_up);
    EXPECT_EQ(translated(event).button, MouseButton::left);
    EXPECT_EQ(translated(event).x_px, 7);

    event = SDL_Event{};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.y = 2;
    EXPECT_EQ(translated(event).dy_px, 2);
    event.wheel.direction = SDL_MOUSEWHEEL_FLIPPED;
    EXPECT_EQ(translated(event).dy_px, -2);
}

TEST(WindowEvents, ClosingIsOneAndTheRestIsIgnored) {
    SDL_Event event{};
    event.type = SDL_QUIT;
    EXPECT_EQ(translated(event).kind, WindowEventKind::closed);
    event.type = SDL_CLIPBOARDUPDATE;
    WindowEvent out;
    EXPECT_FALSE(translate_event(event, out));
}

}  // namespace
}  // namespace tedavis::platform::test_window_event_translation
#endif
