// What lies before a frame: planned, but not shown and not counted.
#include <gtest/gtest.h>

#include "render_core/display/preroll.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_preroll {
namespace {

TEST(Preroll, FramesBeforeAreNotCounted) {
    test_support::MemoryBytes bytes(test_support::hills().image);
    test_support::HeadlessDisplay headless("egl", "es3-mid", 160, 120, &bytes);
    const flight::AircraftState state = test_support::aircraft_over_hills(1400);
    Display& display = headless.display();
    EXPECT_TRUE(display.planner().has_intervals()) << "terrain may be ahead, though there are neither labels nor weights";
    display.plan({state, {}, test_support::kHillsNow});
    EXPECT_EQ(display.record().frame, 0u);
    preroll(display, {state, {}, test_support::kHillsNow});
    settle(display, {state, {}, test_support::kHillsNow});
    display.plan({state, {}, test_support::kHillsNow});
    EXPECT_EQ(display.record().frame, 1u);
    EXPECT_EQ(display.record().labels.placed, 0u);
}

}  // namespace
}  // namespace tedavis::display::test_preroll
