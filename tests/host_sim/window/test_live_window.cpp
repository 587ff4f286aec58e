#include "host_sim/window/live_window.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "tests/host_sim/window/scripted_window.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_live_window {
namespace {

using platform::Key;
using test_support::ScriptedWindow;

using Script = std::function<void(ScriptedWindow&)>;

WindowMaker window_with(const Script& script) {
    return [script](const platform::SurfaceSettings& settings,
                    const char*) -> base::Result<std::unique_ptr<platform::Window>, base::Error> {
        auto surface = platform::make_surface("egl", settings);
        if (!surface.ok()) return base::fail(surface.error());
        auto window = std::make_unique<ScriptedWindow>(std::move(surface.value()));
        script(*window);
        return std::unique_ptr<platform::Window>(std::move(window));
    };
}

struct Voice {
    std::ostringstream results, notes;
    Console console{results, notes, false, false};
};

TEST(LiveWindow, RunsUntilItIsClosedAndLeavesAWholeRun) {
    const test_support::FlownFiles files;
    ReplayOptions options = files.options("run");
    options.window = true;
    Voice voice;
    const int code = run_live_window(options, voice.console, window_with([](ScriptedWindow& window) {
                                         window.press(Key::space);
                                         window.press('2');
                                         window.press(Key::escape);
                                     }));
    EXPECT_EQ(code, 0);
    EXPECT_TRUE(std::filesystem::exists(options.output + "/window.switches"));
    EXPECT_TRUE(std::filesystem::exists(options.output + "/report.html"));
    EXPECT_EQ(test_support::frame_lines(options.output).size(), 1u);
    EXPECT_EQ(test_support::summary_of(options.output).at("switches"), options.output + "/window.switches");
    EXPECT_EQ(test_support::summary_of(options.output).at("interrupted"), false);
    EXPECT_THAT(voice.notes.str(), ::testing::HasSubstr("press h"));
}

TEST(LiveWindow, CtrlCLeavesAWholeRunToo) {
    const test_support::FlownFiles files;
    ReplayOptions options = files.options("run");
    options.window = true;
    Voice voice;
    const int code = run_live_window(options, voice.console, window_with([](ScriptedWindow& window) {
                                         window.press(Key::space);
                                         window.press('4');
                                         window.on_present = [] { raise(SIGINT); };
                                     }));
    EXPECT_EQ(code, kInterruptedExitCode);
    EXPECT_EQ(test_support::frame_lines(options.output).size(), 1u);
    EXPECT_EQ(test_support::summary_of(options.output).at("interrupted"), true);
    EXPECT_THAT(files.folder.read("run/window.switches"), ::testing::HasSubstr("panel.APPROACH 1"));
}

TEST(LiveWindow, CtrlCWhileItOpensLeavesNothing) {
    const test_support::FlownFiles files;
    ReplayOptions options = files.options("run");
    options.window = true;
    Voice voice;
    const WindowMaker window = window_with([](ScriptedWindow&) { raise(SIGINT); });
    EXPECT_THROW(static_cast<void>(run_live_window(options, voice.console, window)), Interrupted);
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

TEST(LiveWindow, WithoutAScreenIsOneSentenceAndNothingIsWritten) {
    const test_support::FlownFiles files;
    ReplayOptions options = files.options("run");
    options.window = true;
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XDG_RUNTIME_DIR"}) unsetenv(variable);
    Voice voice;
    test_support::expect_user_error([&] { static_cast<void>(run_live_window(options, voice.console)); }, "window");
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

}  // namespace
}  // namespace tedavis::host_sim::test_live_window
