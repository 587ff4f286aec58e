#include "host_sim/window/window_controller.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/host_sim/window/scripted_window.hpp"

namespace tedavis::host_sim::test_window_controller {
namespace {

using base::Duration;
using base::radians;
using platform::Key;
using platform::WindowEvent;
using platform::WindowEventKind;
using test_support::ScriptedWindow;

constexpr std::uint32_t kPatterns = 7;
constexpr Duration kStep = Duration::milliseconds(100);

/// A controller over 1000 frames at 10 a second, and hands for it.
struct Session {
    WindowController controller;
    explicit Session(bool has_tour = false) : controller(Transport(1000, kStep, false), kPatterns, has_tour) {}

    void press(Key key, bool shift = false) { controller.handle(ScriptedWindow::key_event(key, '\0', shift)); }
    void press(char character, bool shift = false) {
        controller.handle(ScriptedWindow::key_event(Key::character, character, shift));
    }
    void release(char character) {
        WindowEvent event = ScriptedWindow::key_event(Key::character, character);
        event.kind = WindowEventKind::key_up;
        controller.handle(event);
    }
    void repeat(char character) {
        WindowEvent event = ScriptedWindow::key_event(Key::character, character);
        event.repeat = true;
        controller.handle(event);
    }
    void drag(std::int32_t dx, std::int32_t dy, platform::MouseButton button = platform::MouseButton::left) {
        WindowEvent event;
        event.kind = WindowEventKind::mouse_move;
        event.button = button;
        event.dx_px = dx;
        event.dy_px = dy;
        controller.handle(event);
    }
    [[nodiscard]] std::uint64_t frame() const { return controller.transport().frame(); }
};

CameraPose some_pose() { return {{radians(47), radians(9), {2000}}, radians(90), radians(-5), radians(20)}; }

TEST(WindowController, ASessionOfPlaying) {
    Session session;
    for (int n = 0; n < 10; ++n) session.controller.advance(kStep);
    EXPECT_EQ(session.frame(), 10u);
    session.press(Key::space);
    session.controller.advance(kStep);
    EXPECT_EQ(session.frame(), 10u);
    session.press('.');
    session.press('.');
    session.press(',');
    EXPECT_EQ(session.frame(), 11u);
    session.press(Key::right);
    EXPECT_EQ(session.frame(), 61u);
    session.press(Key::right, true);
    EXPECT_EQ(session.frame(), 661u);
    session.press(Key::left);
    session.press(Key::left, true);
    EXPECT_EQ(session.frame(), 11u);
    session.press(Key::end);
    EXPECT_EQ(session.frame(), 999u);
    session.press(Key::home);
    session.press(Key::space);
    session.press(Key::up);
    session.controller.advance(kStep);
    EXPECT_EQ(session.frame(), 2u);
    session.press(Key::backspace);
    session.press('r');
    session.controller.advance(kStep);
    EXPECT_EQ(session.frame(), 1u);
    session.press(Key::down);
    EXPECT_EQ(session.controller.transport().speed(), 0.5);
}

TEST(WindowController, HeldKeysStepOnButToggleOnce) {
    Session session;
    session.repeat('.');
    session.repeat('.');
    EXPECT_EQ(session.frame(), 2u);
    session.press('c');
    session.repeat('c');
    EXPECT_EQ(session.controller.camera_mode(), CameraMode::free);
    session.press('3');
    static_cast<void>(session.controller.take_pattern());
    session.repeat('3');
    EXPECT_FALSE(session.controller.take_pattern());
}

TEST(WindowController, DigitsAndBracketsSelectPatterns) {
    Session session;
    EXPECT_FALSE(session.controller.take_pattern());
    session.press('3');
    EXPECT_EQ(session.controller.take_pattern(), 2u);
    EXPECT_FALSE(session.controller.take_pattern()) << "told once";
    session.press('8');
    EXPECT_FALSE(session.controller.take_pattern()) << "the panel has seven";
    session.press(']');
    EXPECT_EQ(session.controller.take_pattern(), 3u);
    session.press('7');
    session.press(']');
    EXPECT_EQ(session.controller.take_pattern(), 0u) << "round";
    session.press('[');
    EXPECT_EQ(session.controller.take_pattern(), 6u);
    Session fresh;
    fresh.press('[');
    EXPECT_EQ(fresh.controller.take_pattern(), 6u);
}

TEST(WindowController, TheFreeCameraStartsWhereThePilotLooks) {
    Session session;
    session.controller.record_picture(some_pose(), 500);
    session.press('c');
    EXPECT_EQ(session.controller.camera_mode(), CameraMode::free);
    EXPECT_EQ(session.controller.camera().pose().heading_rad, radians(90));
    EXPECT_EQ(session.controller.camera().pose().roll_rad, 0);
    session.press('c');
    EXPECT_EQ(session.controller.camera_mode(), CameraMode::cockpit);
}

TEST(WindowController, FliesWhileKeysAreHeld) {
    Session session;
    session.controller.record_picture(some_pose(), 500);
    session.press('w');
    session.controller.advance(kStep);
    session.press('c');
    const CameraPose start = session.controller.camera().pose();
    EXPECT_EQ(start.position.longitude_rad, some_pose().position.longitude_rad) << "keys do nothing in the cockpit";
    session.controller.advance(kStep);
    const CameraPose moved = session.controller.camera().pose();
    EXPECT_GT(moved.position.longitude_rad, start.position.longitude_rad);
    session.press('s');
    session.controller.advance(kStep);
    EXPECT_EQ(session.controller.camera().pose().position.longitude_rad, moved.position.longitude_rad) << "both keys";
    session.release('w');
    session.release('s');
    session.press('e');
    session.controller.advance(kStep);
    EXPECT_GT(session.controller.camera().pose().position.height.m, moved.position.height.m);
    session.release('e');
    const double height = session.controller.camera().pose().position.height.m;
    session.controller.advance(kStep);
    EXPECT_EQ(session.controller.camera().pose().position.height.m, height);
}

TEST(WindowController, TheMouseTurnsThePictureWithIt) {
    Session session;
    session.controller.record_picture(some_pose(), 500);
    session.drag(50, 0);
    session.press('c');
    EXPECT_EQ(session.controller.camera().pose().heading_rad, radians(90)) << "not in the cockpit";
    session.drag(50, 0);
    EXPECT_NEAR(session.controller.camera().pose().heading_rad, radians(90) - 0.1, 1e-12);
    session.drag(0, 25);
    EXPECT_NEAR(session.controller.camera().pose().pitch_rad, radians(-5) + 0.05, 1e-12);
    session.drag(50, 50, platform::MouseButton::none);
    EXPECT_NEAR(session.controller.camera().pose().heading_rad, radians(90) - 0.1, 1e-12);
    WindowEvent wheel;
    wheel.kind = WindowEventKind::mouse_wheel;
    wheel.dy_px = 2;
    session.controller.handle(wheel);
    EXPECT_NEAR(session.controller.camera().speed_mps(), 200 * 1.25 * 1.25, 1e-9);
}

TEST(WindowController, ATourIsOnFromTheStartAndCanBeLeft) {
    Session session(true);
    EXPECT_EQ(session.controller.camera_mode(), CameraMode::tour);
    session.press('t');
    EXPECT_EQ(session.controller.camera_mode(), CameraMode::cockpit);
    session.press('t');
    session.controller.record_picture(some_pose(), 500);
    session.press('c');
    EXPECT_EQ(session.controller.camera_mode(), CameraMode::free);
    EXPECT_EQ(session.controller.camera().pose().heading_rad, radians(90)) << "from where the tour was";
    Session without;
    without.press('t');
    EXPECT_EQ(without.controller.camera_mode(), CameraMode::cockpit);
}

TEST(WindowController, KeysTurnTheOverlayOnAndOff) {
    Session session;
    EXPECT_FALSE(session.controller.accuracy().any());
    session.controller.set_accuracy({false, true});
    session.press('i');
    EXPECT_EQ(session.controller.accuracy(), (AccuracyShown{true, true}));
    session.repeat('i');
    EXPECT_TRUE(session.controller.accuracy().figures) << "a held key does not flicker";
    session.press('m');
    EXPECT_EQ(session.controller.accuracy(), (AccuracyShown{true, false}));
}

TEST(WindowController, AKeyTurnsTheSymbologyToNightAndBack) {
    using design::SymbologyLight;
    Session session;
    EXPECT_EQ(session.controller.light(), SymbologyLight::day);
    session.press('n');
    EXPECT_EQ(session.controller.light(), SymbologyLight::night);
    session.repeat('n');
    EXPECT_EQ(session.controller.light(), SymbologyLight::night) << "a held key does not flicker";
    session.press('n');
    EXPECT_EQ(session.controller.light(), SymbologyLight::day);
    session.controller.set_light(SymbologyLight::night);
    session.press('n');
    EXPECT_EQ(session.controller.light(), SymbologyLight::day);
}

TEST(WindowController, AKeyAsksForOneLegendAfterTheOther) {
    using flight::LegendShow;
    Session session;
    EXPECT_FALSE(session.controller.asked_legend()) << "switches and bus are heard until then";
    for (const LegendShow next : {LegendShow::whole, LegendShow::none, LegendShow::key, LegendShow::whole}) {
        session.press('l');
        EXPECT_EQ(session.controller.asked_legend(), next);
    }
    session.repeat('l');
    EXPECT_EQ(session.controller.asked_legend(), LegendShow::whole) << "a held key does not flicker";
    Session other;
    other.controller.set_legend(LegendShow::whole);
    other.press('l');
    EXPECT_EQ(other.controller.asked_legend(), LegendShow::none) << "after the one of the option";
}

TEST(WindowController, TakesAScreenshotWhereItsKeyDoesNotFly) {
    Session session;
    EXPECT_FALSE(session.controller.take_screenshot());
    for (const char key : {'p', 's'}) {
        session.press(key);
        EXPECT_TRUE(session.controller.take_screenshot());
        EXPECT_FALSE(session.controller.take_screenshot());
    }
    session.press('c');
    session.press('s');
    EXPECT_FALSE(session.controller.take_screenshot()) << "it flies back";
    session.press('p');
    EXPECT_TRUE(session.controller.take_screenshot());
}

TEST(WindowController, KeysTurnTheLineAndTheListOnAndOff) {
    Session session;
    EXPECT_TRUE(session.controller.shows_head_up());
    EXPECT_FALSE(session.controller.shows_help());
    session.press('o');
    session.press('h');
    EXPECT_FALSE(session.controller.shows_head_up());
    EXPECT_TRUE(session.controller.shows_help());
    session.press('o');
    session.press('?');
    EXPECT_TRUE(session.controller.shows_head_up());
    EXPECT_FALSE(session.controller.shows_help());
}

TEST(WindowController, ClosesAndHelps) {
    Session session;
    session.press('h');
    EXPECT_TRUE(session.controller.take_help());
    EXPECT_FALSE(session.controller.take_help());
    EXPECT_FALSE(session.controller.closed());
    session.press(Key::escape);
    EXPECT_TRUE(session.controller.closed());
    Session other;
    other.controller.handle(WindowEvent());
    EXPECT_TRUE(other.controller.closed()) << "the window's own close button";
}

}  // namespace
}  // namespace tedavis::host_sim::test_window_controller
