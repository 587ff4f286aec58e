#include "render_core/draw/data/extended_centerline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/ground_section.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_extended_centerline {
namespace {

using test_support::scene_point;

/// Three, 5 km from each other, from south to north.
host_sim::LayerDraft runways() {
    host_sim::LayerDraft layer;
    layer.name = "runways";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::runway;
    for (int n = 0; n < 3; ++n) {
        const scene::ScenePoint first = moved(scene_point(46.8, 9.8, 0), {0, 5000.0 * n});
        layer.points.push_back(first);
        layer.points.push_back(moved(first, {1000, 0}));
        layer.starts.push_back(static_cast<std::uint32_t>(2 * n));
    }
    layer.starts.push_back(6);
    return layer;
}

ApproachFrame frame_at(double north_m, double forward_north) {
    ApproachFrame frame;
    frame.has_own_ship = true;
    const scene::ScenePoint at = moved(scene_point(46.8, 9.8, 0), {0, north_m});
    frame.own_ship = {at.latitude_rad, at.longitude_rad, {500}};
    frame.forward = forward_north * earth::north_east_down(at.latitude_rad, at.longitude_rad)[0];
    return frame;
}

TEST(ExtendedCenterline, P30TheRunwayOfThePlannedFlightHasIt) {
    test_support::ElementOfTest test(runways());
    ApproachFrame frame = frame_at(-3000, 1);
    const scene::ScenePoint to = moved(scene_point(46.8, 9.8, 0), {0, 10'300});
    frame.has_destination = true;
    frame.destination_latitude_rad = to.latitude_rad;
    frame.destination_longitude_rad = to.longitude_rad;
    EXPECT_EQ(approach_of(test.input(), frame).feature, 2u);
}

TEST(ExtendedCenterline, P30WithoutAPlanTheNearestAheadHasIt) {
    test_support::ElementOfTest test(runways());
    EXPECT_EQ(approach_of(test.input(), frame_at(4000, 1)).feature, 1u);
    EXPECT_EQ(approach_of(test.input(), frame_at(4000, -1)).feature, 0u);
    EXPECT_TRUE(approach_of(test.input(), frame_at(4000, 1)).is_any);
    EXPECT_FALSE(approach_of(test.input(), frame_at(11'000, 1)).is_any) << "none is ahead";
    EXPECT_FALSE(approach_of(test.input(), frame_at(-70'000, 1)).is_any) << "too far";
    ApproachFrame lost = frame_at(4000, 1);
    lost.has_own_ship = false;
    EXPECT_FALSE(approach_of(test.input(), lost).is_any) << "control: nobody knows where the own ship is";
}

TEST(ExtendedCenterline, PlacesAreMeasuredAlongTheRunwayAndToItsRight) {
    const scene::ScenePoint first = scene_point(46.8, 9.8, 0), last = moved(first, {1000, 0});
    const scene::ScenePoint at = moved(first, {-2000, -300});
    const glm::dvec2 place = along_and_aside(first, last, {at.latitude_rad, at.longitude_rad, {0}});
    EXPECT_NEAR(place.x, -2000, 1);
    EXPECT_NEAR(place.y, 300, 1);
}

}  // namespace
}  // namespace tedavis::draw::test_extended_centerline
