// What the window must do as a surface stands in tests/contracts; here are its screen and its events.
#include "platform/window/window_surface.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

#include "platform/surface_factory.hpp"
#include "tests/support/programs/virtual_screen.hpp"

#if defined(TEDAVIS_HAVE_SDL2)
#include <SDL.h>
#endif

namespace tedavis::platform::test_window_surface {
namespace {

constexpr SurfaceSettings kSettings{160, 120, ContextLane::es3};

#if defined(TEDAVIS_HAVE_SDL2)

void leave_the_desk() {
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XDG_RUNTIME_DIR"}) unsetenv(variable);
}

TEST(Window, WithoutAScreenIsAnErrorAndNotAHiddenSuccess) {
    leave_the_desk();
    const auto window = make_window(kSettings, "test");
    ASSERT_FALSE(window.ok());
    EXPECT_NE(window.error().message.view().find("no window can be opened"), std::string_view::npos)
        << window.error().message.c_str();
    EXPECT_NE(window.error().message.view().find("--window"), std::string_view::npos);
}

TEST(Window, DriversThatShowNothingAreErrorsByName) {
    leave_the_desk();
    for (const char* driver : {"dummy", "offscreen"}) {
        setenv("SDL_VIDEODRIVER", driver, 1);
        const auto window = make_window(kSettings, "test");
        ASSERT_FALSE(window.ok());
        EXPECT_NE(std::string(window.error().message.view()).find("'" + std::string(driver) + "'"), std::string::npos)
            << window.error().message.c_str();
    }
    unsetenv("SDL_VIDEODRIVER");
}

TEST(Window, IsRefusedWhileAnotherSurfaceIsCurrent) {
    const test_support::VirtualScreen screen;
    auto other = make_surface("egl", kSettings);
    ASSERT_TRUE(other.ok());
    ASSERT_TRUE(other.value()->make_current());
    EXPECT_FALSE(make_window(kSettings, "test").ok());
    EXPECT_EQ(other.value()->present(), base::SurfaceState::ready);
    other.value()->release_current();
    EXPECT_FALSE(make_window({1, 1, ContextLane::es3}, "test").ok());
}

TEST(Window, DeliversEventsInOrderAndKeepsWhatDoesNotFit) {
    const test_support::VirtualScreen screen;
    auto window = make_window(kSettings, "test");
    ASSERT_TRUE(window.ok()) << window.error().message.c_str();
    std::array<WindowEvent, 64> events;
    while (window.value()->poll_events(events) > 0) {
    }  // what opening the window brought
    for (SDL_Keycode code : {SDLK_a, SDLK_b, SDLK_c}) {
        SDL_Event event{};
        event.type = SDL_KEYDOWN;
        event.key.keysym.sym = code;
        ASSERT_EQ(SDL_PushEvent(&event), 1);
    }
    ASSERT_EQ(window.value()->poll_events({events.data(), 2}), 2u);
    EXPECT_EQ(events[0].character, 'a');
    EXPECT_EQ(events[1].character, 'b');
    ASSERT_GE(window.value()->poll_events(events), 1u);
    EXPECT_EQ(events[0].character, 'c');
    window.value()->set_title("other");
}

#else

TEST(Window, IsRefusedByABuildWithoutIt) {
    const auto window = make_window(kSettings, "test");
    ASSERT_FALSE(window.ok());
    EXPECT_NE(window.error().message.view().find("this build has no window"), std::string_view::npos);
}

#endif

}  // namespace
}  // namespace tedavis::platform::test_window_surface
