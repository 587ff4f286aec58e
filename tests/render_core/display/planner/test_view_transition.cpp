#include "render_core/display/planner/view_transition.hpp"

#include <gtest/gtest.h>

namespace tedavis::display::test_view_transition {
namespace {

using base::Duration;
using base::Time;
using design::ViewMode;

constexpr Time kStart{1'700'000'000'000'000'000};
Time after(double seconds) { return kStart + Duration::from_seconds(seconds); }

/// In 3D at kStart.
ViewTransition begun() {
    ViewTransition transition;
    transition.step(ViewMode::perspective, 1, kStart);
    return transition;
}

TEST(ViewTransition, TheFirstFrameIsThereAtOnce) {
    ViewTransition transition;
    transition.step(ViewMode::map, 1, kStart);
    EXPECT_EQ(transition.map_share(), 1);
    EXPECT_FALSE(transition.is_under_way());
    EXPECT_EQ(begun().map_share(), 0);
}

TEST(ViewTransition, TakesItsTimeAtAnEvenRate) {
    for (const double whole_s : {0.5, 1.0, 2.0}) {
        ViewTransition transition = begun();
        for (int n = 1; n <= 20; ++n) {
            transition.step(ViewMode::map, whole_s, after(whole_s * n / 20));
            EXPECT_NEAR(transition.map_share(), n / 20.0, 1e-6);
            EXPECT_EQ(transition.is_under_way(), n < 20);
        }
        transition.step(ViewMode::map, whole_s, after(whole_s * 1.5));
        EXPECT_EQ(transition.map_share(), 1) << "and stays";
    }
}

TEST(ViewTransition, TurnsBackFromWhereItIs) {
    ViewTransition transition = begun();
    transition.step(ViewMode::map, 1, after(0.4));
    transition.step(ViewMode::perspective, 1, after(0.5));
    EXPECT_NEAR(transition.map_share(), 0.3, 1e-6);
    transition.step(ViewMode::perspective, 1, after(0.7));
    EXPECT_NEAR(transition.map_share(), 0.1, 1e-6);
    transition.step(ViewMode::perspective, 1, after(0.81));
    EXPECT_EQ(transition.map_share(), 0);
}

TEST(ViewTransition, TheSameInstantGivesTheSamePlace) {
    ViewTransition transition = begun();
    transition.step(ViewMode::map, 1, after(0.4));
    const double share = transition.map_share();
    for (int n = 0; n < 3; ++n) transition.step(ViewMode::map, 1, after(0.4));
    EXPECT_EQ(transition.map_share(), share);
    ViewTransition finer = begun();
    for (int n = 1; n <= 40; ++n) finer.step(ViewMode::map, 1, after(n / 100.0));
    EXPECT_EQ(finer.map_share(), share) << "however many frames lie between";
}

TEST(ViewTransition, TimeThatGoesBackOrJumpsEndsIt) {
    for (const double then_s : {0.2, -100.0, 1.5, 1000.0}) {
        ViewTransition transition = begun();
        transition.step(ViewMode::map, 1, after(0.4));
        ASSERT_TRUE(transition.is_under_way());
        transition.step(ViewMode::map, 1, after(then_s));
        EXPECT_EQ(transition.map_share(), 1) << then_s;
        transition.step(ViewMode::map, 1, after(then_s + 0.1));
        EXPECT_EQ(transition.map_share(), 1) << then_s;
    }
    ViewTransition goes_on = begun();
    goes_on.step(ViewMode::map, 1, after(0.4));
    goes_on.step(ViewMode::map, 1, after(0.9));
    EXPECT_TRUE(goes_on.is_under_way()) << "control";
}

TEST(ViewTransition, WhereTimeStandsStillTheOtherModeIsThereAtOnce) {
    ViewTransition transition = begun();
    transition.step(ViewMode::map, 1, kStart);
    EXPECT_EQ(transition.map_share(), 1);
    transition.step(ViewMode::perspective, 1, kStart);
    EXPECT_EQ(transition.map_share(), 0);
}

TEST(ViewTransition, ToAndFromTheOrthographicViewThereIsNoWay) {
    for (const ViewMode other : {ViewMode::perspective, ViewMode::map}) {
        ViewTransition transition = begun();
        transition.step(other, 1, after(0.01));
        transition.step(ViewMode::orthographic, 1, after(0.4));
        EXPECT_EQ(transition.map_share(), 1);
        EXPECT_FALSE(transition.is_under_way());
        transition.step(other, 1, after(0.5));
        EXPECT_EQ(transition.map_share(), other == ViewMode::map ? 1 : 0);
        EXPECT_FALSE(transition.is_under_way());
    }
}

TEST(ViewTransition, ArriveLeavesOutTheRest) {
    ViewTransition transition = begun();
    transition.step(ViewMode::map, 1, after(0.4));
    transition.arrive();
    EXPECT_EQ(transition.map_share(), 1);
    transition.step(ViewMode::map, 1, after(0.5));
    EXPECT_EQ(transition.map_share(), 1);
    transition.step(ViewMode::perspective, 1, after(0.6));
    EXPECT_NEAR(transition.map_share(), 0.9, 1e-6) << "the way back is whole";
}

}  // namespace
}  // namespace tedavis::display::test_view_transition
