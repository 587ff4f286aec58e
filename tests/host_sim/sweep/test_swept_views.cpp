#include "host_sim/sweep/swept_views.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_swept_views {
namespace {

TEST(SweptViews, LeastAndMostClutterAreFound) {
    std::vector<SweptView> views(4);
    views[0].measures.clutter = 0.2;
    views[1].measures.clutter = 0.1;
    views[2].measures.clutter = 0.3;
    views[3].measures.clutter = 0.1;
    EXPECT_EQ(least_cluttered(views), 1u) << "the first of two";
    EXPECT_EQ(most_cluttered(views), 2u);
    EXPECT_EQ(most_cluttered({SweptView()}), 0u);
}

TEST(SweptViews, TheStrongestPlaceIsASeenOne) {
    std::vector<SweptView> views(4);
    views[0].saliency = {0.1, 0.1, 0};
    views[1].saliency = {0.3, 0.1, 0};
    views[2].saliency = {0.6, 0.1, 0};
    views[3].saliency = {0.3, 0.1, 0};
    views[2].sight = PlaceSight::behind_terrain;
    EXPECT_EQ(strongest_place(views), 1u);
    views[0].sight = views[1].sight = PlaceSight::outside_picture;
    EXPECT_EQ(strongest_place(views), 3u);
    views[3].sight = PlaceSight::behind_terrain;
    EXPECT_FALSE(strongest_place(views).has_value());
}

TEST(SweptViews, SightsHaveNames) {
    EXPECT_STREQ(sight_name(PlaceSight::seen), "seen");
    EXPECT_STREQ(sight_name(PlaceSight::behind_terrain), "behind terrain");
    EXPECT_STREQ(sight_name(PlaceSight::outside_picture), "outside the picture");
}

}  // namespace
}  // namespace tedavis::host_sim::test_swept_views
