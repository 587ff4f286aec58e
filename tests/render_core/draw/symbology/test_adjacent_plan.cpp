#include "render_core/draw/symbology/adjacent_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::draw::test_adjacent_plan {
namespace {

TEST(AdjacentPlan, MapsAreNoLargerThanWantedWhereThatCanBe) {
    EXPECT_EQ(maps_across({1, 5}, 5), 1u);
    EXPECT_EQ(maps_across({9, 5}, 5), 1u);
    EXPECT_EQ(maps_across({9, 2.5f}, 5), 2u);
    EXPECT_EQ(maps_across({9, 2.4f}, 5), 3u) << "two have a side of 2.425";
    EXPECT_EQ(maps_across({9, 0.5f}, 5), kMaxMapsAcross);
    EXPECT_EQ(maps_across({1, 1.6f}, 5), 1u) << "one alone has the whole width";
}

TEST(AdjacentPlan, EveryMapIsAWholeSquareInThePanelAndCoversNoOther) {
    for (const float t : {8.0f, 12.3f, 16.0f, 25.6f, 72.0f})
        for (std::uint32_t maps = 1; maps <= 16; ++maps)
            for (std::uint32_t across = 1; across <= kMaxMapsAcross; ++across) {
                const Rect panel{10.3f, 20.7f, 5 * t, adjacent_height(maps, across, 5) * t};
                const AdjacentPlan plan = plan_adjacent(panel, maps, t);
                EXPECT_LE(plan.across, across) << "never smaller than there is room for";
                for (std::uint32_t n = 0; n < maps; ++n) {
                    const Rect box = plan.box_of(n);
                    EXPECT_EQ(box.width, box.height);
                    EXPECT_EQ(box.x, std::round(box.x));
                    EXPECT_EQ(box.y, std::round(box.y));
                    EXPECT_EQ(box.width, std::round(box.width));
                    EXPECT_GE(box.width, 1.4f * t);
                    EXPECT_TRUE(panel.shrunk(-0.01f).contains(box)) << maps << " " << across << " " << t;
                    EXPECT_GE(box.y, panel.y + kAdjacentCaption * t);
                    for (std::uint32_t other = 0; other < n; ++other) EXPECT_FALSE(box.overlaps(plan.box_of(other)));
                }
            }
}

}  // namespace
}  // namespace tedavis::draw::test_adjacent_plan
