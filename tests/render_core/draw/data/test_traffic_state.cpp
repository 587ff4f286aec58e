#include "render_core/draw/data/traffic_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_traffic_state {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kStart_ns = 1'780'000'000 * kSecond_ns;

/// Reports every five seconds, 300 m farther north and 10 m higher each; the fourth comes a minute after the third.
host_sim::LayerDraft reports() {
    host_sim::LayerDraft layer;
    layer.name = "traffic";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::traffic;
    const double north = base::degrees(300 / earth::meridian_radius_m(base::radians(46.8)));
    const int seconds[] = {0, 5, 10, 70};
    for (int n = 0; n < 4; ++n) {
        layer.points.push_back(scene_point(46.8 + n * north, 9.8, 2000 + 10.0f * static_cast<float>(n)));
        layer.points.back().time_ns = kStart_ns + seconds[n] * kSecond_ns;
    }
    layer.starts = {0, 4};
    return layer;
}

TrafficState at(ElementOfTest& test, double second) {
    test.has_date = true;
    test.time_ns = kStart_ns + static_cast<std::int64_t>(second * 1e9);
    return traffic_state(test.input(), 0);
}

double gone_m(const TrafficState& state) {
    return (state.point.latitude_rad - base::radians(46.8)) * earth::meridian_radius_m(base::radians(46.8));
}

TEST(TrafficState, IsBetweenTwoReports) {
    ElementOfTest test(reports());
    const TrafficState state = at(test, 7.5);
    EXPECT_TRUE(state.is_known);
    EXPECT_NEAR(gone_m(state), 450, 0.1);
    EXPECT_NEAR(static_cast<double>(state.point.height_m), 2015, 0.01);
    EXPECT_NEAR(state.north, 60, 0.05);
    EXPECT_NEAR(state.east, 0, 0.01);
    EXPECT_NEAR(state.up, 2, 1e-3);
    EXPECT_EQ(state.age_s, 0);
    EXPECT_FALSE(state.is_stale);
}

TEST(TrafficState, GoesOnForTenSecondsThenIsStaleThenGone) {
    ElementOfTest test(reports());
    EXPECT_NEAR(gone_m(at(test, 16)), 600 + 6 * 60, 0.5) << "the next report is a minute away";
    EXPECT_NEAR(at(test, 16).age_s, 6, 1e-9);
    EXPECT_FALSE(at(test, 20).is_stale);
    const TrafficState stale = at(test, 40);
    EXPECT_TRUE(stale.is_known);
    EXPECT_TRUE(stale.is_stale);
    EXPECT_NEAR(gone_m(stale), 600 + 10 * 60, 0.5) << "no farther";
    EXPECT_NEAR(gone_m(at(test, 70)), 900, 0.1) << "there again";
    EXPECT_FALSE(at(test, 70).has_velocity) << "a minute may hold any way";
    EXPECT_TRUE(at(test, 69.9 + kRemoved_s).is_known);
    EXPECT_FALSE(at(test, 70.1 + kRemoved_s).is_known);
}

TEST(TrafficState, IsNotKnownBeforeItsFirstReport) {
    ElementOfTest test(reports());
    EXPECT_FALSE(at(test, -0.1).is_known);
    EXPECT_TRUE(at(test, 0).is_known);
}

TEST(TrafficState, WithoutADateItStandsAtItsLastReport) {
    ElementOfTest test(reports());
    const TrafficState state = traffic_state(test.input(), 0);
    EXPECT_TRUE(state.is_known);
    EXPECT_NEAR(gone_m(state), 900, 0.1);
    EXPECT_EQ(state.age_s, 0);
}

TEST(TrafficState, WithoutAConfirmedTimeItsAgeIsUnknownAndItIsStale) {
    ElementOfTest test(reports());
    test.has_date = true;
    for (const double second : {7.5, 15.0}) {
        test.time_ns = kStart_ns + static_cast<std::int64_t>(second * 1e9);
        ElementInput input = test.input();
        input.has_age = false;
        EXPECT_TRUE(std::isnan(traffic_state(input, 0).age_s)) << second;
        EXPECT_TRUE(traffic_state(input, 0).is_stale) << second;
        EXPECT_EQ(gone_m(traffic_state(input, 0)), gone_m(traffic_state(test.input(), 0))) << second;
    }
}

/// By the rule in words: 3 m/s2 for ten seconds, then 60 m/s and the 30 m/s that may have been gained; upright 1, 2 and 10.
TEST(TrafficState, ItsPlaceIsLessSureTheOlderTheReportIs) {
    host_sim::LayerDraft layer = reports();
    layer.position_accuracy_m = 90;
    layer.height_accuracy_m = 45;
    ElementOfTest test(layer);
    EXPECT_NEAR(at(test, 7.5).accuracy.level_m, 90, 1e-9) << "between two reports";
    EXPECT_NEAR(at(test, 14).accuracy.level_m, 90 + 24, 1e-6);
    EXPECT_NEAR(at(test, 14).accuracy.height_m, 45 + 8, 1e-6);
    EXPECT_NEAR(at(test, 40).accuracy.level_m, 90 + 150 + 20 * (60 + 30), 1);
    EXPECT_NEAR(at(test, 40).accuracy.height_m, 45 + 50 + 20 * (2 + 10), 0.1);
    EXPECT_NEAR(at(test, 74).accuracy.level_m, 90 + 4 * kAnySpeed_mps, 1e-6) << "nobody knows how fast it is";
    EXPECT_NEAR(at(test, 74).accuracy.height_m, 45 + 4 * kAnyClimb_mps, 1e-6);
    for (double second = 10; second < 69; second += 0.5)
        EXPECT_LE(at(test, second).accuracy.level_m, at(test, second + 0.5).accuracy.level_m) << second;
    ElementInput input = test.input();
    input.has_age = false;
    EXPECT_EQ(traffic_state(input, 0).accuracy.level_m, 0) << "of unknown age: nobody knows";
    ElementOfTest unstated(reports());
    EXPECT_EQ(at(unstated, 40).accuracy.level_m, 0) << "what was not stated does not become known";
}

TEST(TrafficState, ReportsWithoutTimesOrHeightsOrTwiceDoNoHarm) {
    host_sim::LayerDraft layer = reports();
    for (scene::ScenePoint& point : layer.points) point.time_ns = scene::kNoTime;
    ElementOfTest timeless(layer);
    EXPECT_TRUE(at(timeless, 3).is_known);
    EXPECT_FALSE(at(timeless, 3).has_velocity);
    layer = reports();
    layer.points[1].time_ns = layer.points[0].time_ns;
    layer.points[2].height_m = std::numeric_limits<float>::quiet_NaN();
    ElementOfTest doubtful(layer);
    EXPECT_TRUE(std::isfinite(at(doubtful, 0).point.latitude_rad));
    EXPECT_EQ(at(doubtful, 7).up, 0) << "no height, no climb";
}

/// 2015 m high and 450 m north of 46.8 at second 7.5. Control: what is as near and old, or of unknown height, is not proximate.
TEST(TrafficState, P34IsProximateWithinSixMilesAndTwelveHundredFeetOfTheOwnShip) {
    ElementOfTest test(reports());
    const double mile = base::degrees(1852 / earth::meridian_radius_m(base::radians(46.8)));
    const auto is_near = [&](double second, double miles_south, double own_m, bool is_known = true) {
        const TrafficState state = at(test, second);
        ElementInput input = test.input();
        const double latitude = 46.8 - miles_south * mile;
        input.own_ship = {{base::radians(latitude), base::radians(9.8), {own_m}}, is_known, is_known};
        return is_proximate(input, state, static_cast<double>(state.point.height_m));
    };
    EXPECT_TRUE(is_near(7.5, 0, 2000));
    EXPECT_TRUE(is_near(7.5, 5.7, 2000)) << "with the 450 m";
    EXPECT_FALSE(is_near(7.5, 5.8, 2000));
    EXPECT_TRUE(is_near(7.5, 0, 2015 - 365));
    EXPECT_FALSE(is_near(7.5, 0, 2015 - 367));
    EXPECT_FALSE(is_near(7.5, 0, 2015 + 367));
    EXPECT_FALSE(is_near(7.5, 0, 2000, false)) << "nobody knows where the own ship is";
    EXPECT_TRUE(is_near(18, 0, 2000));
    EXPECT_FALSE(is_near(25, 0, 2000)) << "stale";
    host_sim::LayerDraft flat = reports();
    for (scene::ScenePoint& point : flat.points) point.height_m = std::numeric_limits<float>::quiet_NaN();
    ElementOfTest unknown(flat);
    const TrafficState state = at(unknown, 7.5);
    ElementInput input = unknown.input();
    input.own_ship = {{base::radians(46.8), base::radians(9.8), {600}}, true, true};
    EXPECT_FALSE(is_proximate(input, state, 600)) << "its height is not known";
}

}  // namespace
}  // namespace tedavis::draw::test_traffic_state
