#include "host_sim/window/window_keys.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/host_sim/window/scripted_window.hpp"

namespace tedavis::host_sim::test_window_keys {
namespace {

using platform::Key;
using test_support::ScriptedWindow;

KeyMeaning of(Key key, bool shift = false) { return meaning_of_key(ScriptedWindow::key_event(key, '\0', shift)); }
KeyMeaning of(char character, bool shift = false) {
    return meaning_of_key(ScriptedWindow::key_event(Key::character, character, shift));
}

TEST(WindowKeys, EveryActionHasItsKey) {
    std::set<WindowAction> reached;
    for (const bool shift : {false, true}) {
        for (char c = ' '; c < 127; ++c) reached.insert(of(c, shift).action);
        for (int key = 0; key <= static_cast<int>(Key::end); ++key) reached.insert(of(static_cast<Key>(key), shift).action);
    }
    EXPECT_EQ(reached.size(), static_cast<std::size_t>(WindowAction::fly_down) + 1);
}

TEST(WindowKeys, ArrowsSeekAndWithShiftFurther) {
    EXPECT_EQ(of(Key::right).action, WindowAction::seek_forward);
    EXPECT_EQ(of(Key::left).action, WindowAction::seek_back);
    EXPECT_EQ(of(Key::right, true).action, WindowAction::seek_far_forward);
    EXPECT_EQ(of(Key::left, true).action, WindowAction::seek_far_back);
}

TEST(WindowKeys, DigitsArePatterns) {
    EXPECT_EQ(of('1').action, WindowAction::switch_pattern);
    EXPECT_EQ(of('1').pattern, 0u);
    EXPECT_EQ(of('9').pattern, 8u);
    EXPECT_EQ(of('0').pattern, 9u);
    EXPECT_EQ(of('1', true).pattern, 10u);
    EXPECT_EQ(of('0', true).pattern, 19u);
}

TEST(WindowKeys, HelpAndTheFrameHaveKeys) {
    for (const KeyMeaning& meaning : {of('h'), of('?'), of('/', true)}) EXPECT_EQ(meaning.action, WindowAction::help);
    EXPECT_EQ(of('/').action, WindowAction::none);
    EXPECT_EQ(of('p').action, WindowAction::screenshot);
    EXPECT_EQ(of('o').action, WindowAction::head_up);
}

TEST(WindowKeys, OtherKeysMeanNothing) {
    EXPECT_EQ(of('x').action, WindowAction::none);
    EXPECT_EQ(of(Key::tab).action, WindowAction::none);
    EXPECT_EQ(of(Key::other).action, WindowAction::none);
}

TEST(WindowKeys, HelpNamesThemAll) {
    const std::string help = window_keys_help();
    for (const char* word :
         {"space", "escape", "backspace", "home end", "w s a d e q", "1 .. 9 0", "proven error", "error of the ground",
          "symbology by night", "mouse", "window.switches", "screenshot", "h ?", "line with time"})
        EXPECT_THAT(help, ::testing::HasSubstr(word));
    std::string lines;
    for (const std::string& line : window_keys_lines()) lines += line + "\n";
    EXPECT_EQ(lines, help);
}

}  // namespace
}  // namespace tedavis::host_sim::test_window_keys
