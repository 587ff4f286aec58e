#include "host_sim/window/start_screen.hpp"

#include <gtest/gtest.h>

#include "host_sim/user_error.hpp"
#include "tests/host_sim/window/scripted_window.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_start_screen {
namespace {

using platform::Key;
using test_support::ScriptedWindow;

constexpr std::uint64_t kLarge = 1u << 30;

base::Time at_ms(std::int64_t ms) { return base::Time{} + base::Duration::milliseconds(ms); }

struct Start {
    Start() {
        const SurfaceMaker make =
            [this](const platform::SurfaceSettings& settings) -> base::Result<std::unique_ptr<base::Surface>, base::Error> {
            auto surface = platform::make_surface("egl", settings);
            if (!surface.ok()) return base::fail(surface.error());
            auto made = std::make_unique<ScriptedWindow>(std::move(surface.value()));
            window = made.get();
            return std::unique_ptr<base::Surface>(std::move(made));
        };
        session = std::make_unique<DisplaySession>(files.options("unused").picture, false, make);
        screen.emplace(*window, *session, "a.log");
    }
    test_support::FlownFiles files;
    ScriptedWindow* window = nullptr;
    std::unique_ptr<DisplaySession> session;
    std::optional<StartScreen> screen;
};

TEST(StartScreen, KeepsKeysInOrderAndIsShownNowAndThen) {
    Start start;
    start.window->press(Key::space);
    start.screen->show(0, kLarge, at_ms(0));
    start.window->press('3');
    start.screen->show(1, kLarge, at_ms(50));
    EXPECT_EQ(start.window->presented(), 1);
    EXPECT_EQ(start.screen->events().size(), 1u);
    start.screen->show(kLarge / 2, kLarge, at_ms(100));
    EXPECT_EQ(start.window->presented(), 2);
    ASSERT_EQ(start.screen->events().size(), 2u);
    EXPECT_EQ(start.screen->events()[0].key, Key::space);
    EXPECT_EQ(start.screen->events()[1].character, '3');
}

TEST(StartScreen, ASmallLogLeavesTheEventsInTheWindow) {
    Start start;
    start.window->press(Key::escape);
    start.screen->show(0, 1000, at_ms(0));
    EXPECT_EQ(start.window->presented(), 0);
    platform::WindowEvent event;
    EXPECT_EQ(start.window->poll_events({&event, 1}), 1u);
}

TEST(StartScreen, ClosingTheWindowEndsIt) {
    Start start;
    start.window->press(Key::escape);
    EXPECT_THROW(start.screen->show(0, kLarge, at_ms(0)), Interrupted);
    start.window->send(platform::WindowEvent());
    EXPECT_THROW(start.screen->show(0, kLarge, at_ms(200)), Interrupted);
    EXPECT_NO_THROW(start.screen->show(0, kLarge, at_ms(400)));
}

}  // namespace
}  // namespace tedavis::host_sim::test_start_screen
