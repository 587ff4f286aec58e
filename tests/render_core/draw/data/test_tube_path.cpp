#include "render_core/draw/data/tube_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_tube_path {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;

constexpr std::int64_t kSecond_ns = 1'000'000'000, kStart_ns = 1'586'684'820 * kSecond_ns;

/// Circles of 2 km over the same place, a point a second.
host_sim::LayerDraft circling(std::size_t count) {
    host_sim::LayerDraft layer;
    layer.name = "flight";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    for (std::size_t n = 0; n < count; ++n) {
        const double turn = 0.02 * static_cast<double>(n);
        layer.points.push_back(
            scene_point(46.8 + 0.018 * std::cos(turn), 9.8 + 0.026 * std::sin(turn), 2000 + static_cast<float>(n) * 0.1f));
        layer.points.back().time_ns = kStart_ns + static_cast<std::int64_t>(n) * kSecond_ns;
    }
    layer.starts = {0, static_cast<std::uint32_t>(count)};
    return layer;
}

class TubeWayOfTest : public ::testing::Test {
protected:
    TubeWayOfTest() : memory_(TubePath::bytes_needed() + TubeLine::bytes_needed(kRoom)) {
        base::Arena arena(memory_.data(), memory_.size());
        EXPECT_TRUE(way.start(arena) && line.start(arena, kRoom));
    }
    /// Points of the first line that are kept.
    std::size_t kept(ElementOfTest& test, std::uint32_t most_points = kRoom) {
        const ElementInput input = test.input();
        way.plan(input, most_points);
        way.read(0, line);
        return line.points().size();
    }

    static constexpr std::uint32_t kRoom = 4096;
    TubePath way;
    TubeLine line;

private:
    std::vector<unsigned char> memory_;
};

TEST_F(TubeWayOfTest, DetailIsATolerance) {
    ElementOfTest test(circling(3000));
    std::size_t before = 3001;
    for (const double detail : {1.0, 0.5, 0.0}) {
        test.element.detail = detail;
        const std::size_t now = kept(test);
        EXPECT_LT(now, before);
        EXPECT_EQ(now + line.left_out, 3000u);
        EXPECT_DOUBLE_EQ(way.tolerance_m(), kDefaultTubeRadius_m * std::pow(10.0, 1 - 2 * detail));
        before = now;
    }
}

TEST_F(TubeWayOfTest, NoPointIsFartherFromTheTubeThanItsTolerance) {
    const host_sim::LayerDraft layer = circling(3000);
    ElementOfTest test(layer);
    test.element.detail = 0.4;
    static_cast<void>(kept(test));
    std::size_t from = 0;
    double worst_m = 0;
    for (std::size_t k = 1; k < line.points().size(); ++k) {
        const std::size_t to = line.numbers()[k];
        for (std::size_t n = from + 1; n < to; ++n) {
            const scene::ScenePoint& p = layer.points[n];
            const glm::dvec3 at = earth::to_ecef({p.latitude_rad, p.longitude_rad, {static_cast<double>(p.height_m) + 50}});
            worst_m = std::max(
                worst_m, distance_from_segment({at, {}}, {line.points()[k - 1].position, {}}, {line.points()[k].position, {}}));
        }
        from = to;
    }
    EXPECT_EQ(from, 2999u) << "to the end, over all windows";
    EXPECT_GT(worst_m, 0.2 * way.tolerance_m());
    EXPECT_LE(worst_m, way.tolerance_m() + 1e-3);
}

TEST_F(TubeWayOfTest, LittleRoomWidensTheTolerance) {
    ElementOfTest test(circling(3000));
    test.element.detail = 1;
    for (const std::uint32_t room : {300u, 100u, 40u}) {
        const std::size_t now = kept(test, room);
        EXPECT_LE(now, room);
        EXPECT_GT(now, room / 4) << "and no more than is needed";
    }
    EXPECT_GE(kept(test, 1), 7u) << "ends of windows stay whatever the room";
}

TEST_F(TubeWayOfTest, ChangesOfAValueAreKeptAndSoAreItsGaps) {
    host_sim::LayerDraft layer = circling(0);
    for (int n = 0; n < 200; ++n) layer.points.push_back(scene_point(46.8 + 0.0005 * n, 9.8, 2000));
    layer.starts = {0, 200};
    ElementOfTest plain(layer);
    EXPECT_EQ(kept(plain), 2u);
    host_sim::AttributeDraft speed;
    speed.name = "speed";
    for (int n = 0; n < 200; ++n) speed.values.push_back(n < 80 ? 10.0f : 50.0f);
    for (int n = 150; n < 160; ++n) speed.values[static_cast<std::size_t>(n)] = std::numeric_limits<float>::quiet_NaN();
    layer.attributes.push_back(speed);
    ElementOfTest colored(layer);
    colored.element.by_color.attribute = "speed";
    EXPECT_EQ(kept(colored), 8u) << "both sides of the step and of both borders of what is missing";
    const auto numbers = line.numbers();
    EXPECT_EQ(std::vector<std::uint32_t>(numbers.begin(), numbers.end()),
              (std::vector<std::uint32_t>{0, 79, 80, 149, 150, 159, 160, 199}));
}

TEST_F(TubeWayOfTest, PlacesThatAreNoneAreGapsAndTimeRunningBackAnEnd) {
    host_sim::LayerDraft layer = circling(0);
    for (int n = 0; n < 60; ++n) {
        layer.points.push_back(scene_point(46.8 + 0.0005 * n, 9.8, 2000));
        layer.points.back().time_ns = kStart_ns + (n < 40 ? n : n - 20) * kSecond_ns;
    }
    for (std::size_t n = 20; n < 23; ++n) layer.points[n].height_m = std::numeric_limits<float>::quiet_NaN();
    layer.starts = {0, 60};
    ElementOfTest test(layer);
    test.ground.is_known = false;
    EXPECT_EQ(kept(test), 7u) << "four stretches' ends but for the gap, which is one point";
    EXPECT_TRUE(std::isnan(line.points()[2].position.x));
    EXPECT_EQ(line.numbers()[4], 39u);
    EXPECT_EQ(line.numbers()[5], 40u);
}

TEST_F(TubeWayOfTest, RadiiFollowTheirAttribute) {
    host_sim::LayerDraft layer = circling(4);
    host_sim::AttributeDraft mass;
    mass.name = "mass";
    mass.values = {5, 10, 0, std::numeric_limits<float>::quiet_NaN()};
    layer.attributes.push_back(mass);
    ElementOfTest test(layer);
    test.element.size_attribute = "mass";
    test.element.size_m = 200;
    ASSERT_EQ(kept(test), 4u);
    const double expected_m[] = {100, 200, 20, 20};
    for (std::size_t n = 0; n < 4; ++n) EXPECT_NEAR(static_cast<double>(line.points()[n].radius_m), expected_m[n], 1e-4);
}

TEST_F(TubeWayOfTest, OtherAircraftHaveComeSoFar) {
    host_sim::LayerDraft layer = circling(1000);
    layer.role = scene::LayerRole::traffic;
    ElementOfTest test(layer);
    static_cast<void>(kept(test));
    EXPECT_EQ(line.numbers()[line.numbers().size() - 1], 999u) << "without a date all of it";
    test.has_date = true;
    test.time_ns = kStart_ns + 400 * kSecond_ns;
    static_cast<void>(kept(test));
    const auto last = static_cast<std::uint32_t>(line.numbers().size()) - 1;
    EXPECT_TRUE(std::isnan(line.points()[last].position.x));
    EXPECT_EQ(line.numbers()[last - 1], 400u);
}

TEST_F(TubeWayOfTest, InSpaceTimeHeightIsTime) {
    host_sim::LayerDraft layer = circling(3601);
    layer.points[7].time_ns = scene::kNoTime;
    ElementOfTest test(layer);
    test.element.technique = design::DataTechnique::space_time;
    test.element.size_m = 2500;
    static_cast<void>(kept(test));
    ASSERT_GT(line.points().size(), 20u);
    bool has_gap = false;
    for (std::size_t n = 0; n < line.points().size(); ++n) {
        has_gap = has_gap || line.numbers()[n] == 7;
        if (line.numbers()[n] == 7) continue;
        EXPECT_NEAR(earth::from_ecef(line.points()[n].position).height.m, 600 + 2500 * line.numbers()[n] / 3600.0, 1e-3);
        EXPECT_NEAR(static_cast<double>(line.points()[n].radius_m), kDefaultTubeRadius_m, 1e-4);
    }
    EXPECT_TRUE(has_gap) << "without a time there is no place";
    test.ground.is_known = false;
    EXPECT_EQ(kept(test), 1u) << "nothing but a gap";
}

}  // namespace
}  // namespace tedavis::draw::test_tube_path
