#include "host_sim/sweep/place_in_picture.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_place_in_picture {
namespace {

/// Looks along x; right is y, down is -z.
terrain::View view() {
    terrain::View view{};
    view.eye = {1000, 0, 0};
    view.forward = {1, 0, 0};
    view.right = {0, 1, 0};
    view.down = {0, 0, -1};
    view.focal_px = 100;
    view.width = 200;
    view.height = 100;
    return view;
}

TEST(PlaceInPicture, IsProjected) {
    const PlaceInPicture ahead = place_in_picture(view(), {2000, 0, 0}, 100);
    EXPECT_TRUE(ahead.is_inside);
    EXPECT_DOUBLE_EQ(ahead.x_px, 100);
    EXPECT_DOUBLE_EQ(ahead.y_px, 50);
    EXPECT_DOUBLE_EQ(ahead.radius_px, 10);
    const PlaceInPicture beside = place_in_picture(view(), {1500, 250, 100}, 1);
    EXPECT_DOUBLE_EQ(beside.x_px, 150) << "to the right";
    EXPECT_DOUBLE_EQ(beside.y_px, 30) << "above";
    EXPECT_DOUBLE_EQ(beside.radius_px, PlaceInPicture::kMinRadius_px);
}

TEST(PlaceInPicture, MayLieOutside) {
    EXPECT_FALSE(place_in_picture(view(), {0, 0, 0}, 100).is_inside) << "behind";
    EXPECT_FALSE(place_in_picture(view(), {2000, 1001, 0}, 100).is_inside);
    EXPECT_FALSE(place_in_picture(view(), {2000, 0, -501}, 100).is_inside);
    EXPECT_TRUE(place_in_picture(view(), {2000, -999, 499}, 100).is_inside);
}

FloatMap flat_map(float value) { return {40, 20, 1, 1, std::vector<float>(800, value)}; }

TEST(PlaceSaliency, OfAnEvenMapIsItsArea) {
    const PlaceSaliency saliency = place_saliency(flat_map(0.3f), {true, 20, 10, 5});
    EXPECT_NEAR(saliency.area, 0.1, 0.01) << "a disk of radius 5";
    EXPECT_NEAR(saliency.times_mean(), 1, 1e-6);
    EXPECT_EQ(saliency.rank, 0) << "nothing is less";
    EXPECT_EQ(place_saliency(flat_map(0), {true, 20, 10, 5}).share, 0);
}

TEST(PlaceSaliency, OfTheOnlyStrongPlaceIsAll) {
    FloatMap map = flat_map(0);
    map.values[10 * 40 + 20] = 1;
    const PlaceSaliency there = place_saliency(map, {true, 20, 10, 5}), elsewhere = place_saliency(map, {true, 5, 5, 3});
    EXPECT_EQ(there.share, 1);
    EXPECT_NEAR(there.rank, 799.0 / 800, 1e-12) << "all others are less";
    EXPECT_EQ(elsewhere.share, 0);
    EXPECT_EQ(elsewhere.rank, 0);
    EXPECT_EQ(elsewhere.times_mean(), 0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_place_in_picture
