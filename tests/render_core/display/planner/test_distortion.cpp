#include "render_core/display/planner/distortion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"

namespace tedavis::display::test_distortion {
namespace {

using base::radians;

/// Foci at 47 N, so many kilometres east of 9 E, and the own ship far away.
struct Foci {
    design::FocusList list;
    std::vector<scene::FocusRegion> regions;

    scene::FocusRegion& add(double east_km, std::uint32_t power = 1, double radius_m = 1000, double context_m = 5000) {
        design::FocusSettings focus;
        focus.power = power;
        EXPECT_TRUE(list.try_push_back(focus));
        scene::FocusRegion region = scene::focus_region_at(radians(47), radians(9));
        region.point_count = 1;
        region.points[0] = {1000 * east_km, 0};
        region.radius_m = radius_m;
        region.context.width_m = context_m;
        regions.push_back(region);
        return regions.back();
    }
    [[nodiscard]] DistortionScene scene(double own_east_km = -100) const {
        DistortionScene scene{list, {regions.data(), regions.size()}};
        scene.is_far = scene.shows_terrain = scene.has_position = true;
        const scene::FocusRegion& first = regions[0];
        scene.own_ship = first.anchor + first.east * (1000 * own_east_km);
        scene.ground_speed_mps = 60;
        return scene;
    }
};

TEST(Distortion, AFocusIsShownLargerWhereItSaysSo) {
    Foci foci;
    foci.add(0, 2, 1000, 7000);
    const DistortionPlan plan = plan_distortion(foci.scene());
    ASSERT_EQ(plan.records.size(), 1u);
    ASSERT_EQ(plan.magnifiers.size(), 1u);
    const DistortionRecord& record = plan.records[0];
    EXPECT_EQ(record.state, DistortionState::shown);
    EXPECT_STREQ(reason_of(record.state), "");
    EXPECT_EQ(record.power, 2u);
    EXPECT_EQ(record.compression, 1u);
    EXPECT_NEAR(record.middle.latitude_rad, radians(47), 1e-9);
    EXPECT_EQ(record.reach_m, plan.magnifiers.begin()->reach_m());
    const glm::dvec3 place = foci.regions[0].anchor + foci.regions[0].east * 500.0;
    EXPECT_NEAR(glm::distance(plan.magnifiers.moved(place), foci.regions[0].anchor), 2000, 1e-6);
}

TEST(Distortion, NothingIsMovedThatThePilotSeesAhead) {
    Foci foci;
    foci.add(0);
    DistortionScene scene = foci.scene();
    scene.is_far = false;
    const DistortionPlan plan = plan_distortion(scene);
    EXPECT_TRUE(plan.magnifiers.empty());
    ASSERT_EQ(plan.records.size(), 1u);
    EXPECT_EQ(plan.records[0].state, DistortionState::egocentric);
    EXPECT_EQ(plan.records[0].reach_m, 0);
    EXPECT_EQ(plan.records[0].compression, 0u);
}

TEST(Distortion, TheOwnShipAndHalfAMinuteOfItsWayStayClear) {
    Foci foci;
    foci.add(0);
    const double reach_km = 1e-3 * plan_distortion(foci.scene()).magnifiers.begin()->reach_m();
    struct Case {
        double beyond_km, speed_mps;
        DistortionState state;
    };
    for (const Case& c : {Case{2.1, 20, DistortionState::shown}, Case{1.9, 20, DistortionState::own_ship},
                          Case{6.1, 200, DistortionState::shown}, Case{5.9, 200, DistortionState::own_ship},
                          Case{7.4, std::nan(""), DistortionState::own_ship}, Case{7.6, std::nan(""), DistortionState::shown}}) {
        DistortionScene scene = foci.scene(-(reach_km + c.beyond_km));
        scene.ground_speed_mps = c.speed_mps;
        EXPECT_EQ(plan_distortion(scene).records[0].state, c.state) << c.beyond_km << ' ' << c.speed_mps;
    }
    EXPECT_EQ(plan_distortion(foci.scene(0)).records[0].state, DistortionState::own_ship);
}

TEST(Distortion, WhatSpeaksAgainstItIsSaid) {
    Foci foci;
    foci.add(0);
    DistortionScene scene = foci.scene();
    scene.shows_terrain = false;
    EXPECT_EQ(plan_distortion(scene).records[0].state, DistortionState::no_terrain);
    DistortionScene lost = foci.scene();
    lost.has_position = false;
    EXPECT_EQ(plan_distortion(lost).records[0].state, DistortionState::no_position);
    foci.regions[0].context.width_m = 900;
    EXPECT_EQ(plan_distortion(foci.scene()).records[0].state, DistortionState::too_narrow);
    foci.regions[0].point_count = 2;
    EXPECT_EQ(plan_distortion(foci.scene()).records[0].state, DistortionState::not_one);
    foci.regions[0].is_valid = false;
    EXPECT_EQ(plan_distortion(foci.scene()).records[0].state, DistortionState::no_place);
    std::set<std::string> reasons;
    for (int n = 1; n <= static_cast<int>(DistortionState::over_budget); ++n)
        EXPECT_TRUE(reasons.insert(reason_of(static_cast<DistortionState>(n))).second) << n;
    EXPECT_EQ(reasons.count(""), 0u);
}

TEST(Distortion, OfTwoThatWouldOverlapTheFirstIsShown) {
    Foci foci;
    foci.add(0);
    foci.add(4);
    foci.add(9);
    foci.add(20, 0);
    const DistortionPlan plan = plan_distortion(foci.scene());
    ASSERT_EQ(plan.records.size(), 3u) << "who does not ask for it has no record";
    EXPECT_EQ(plan.records[0].state, DistortionState::shown);
    EXPECT_EQ(plan.records[1].state, DistortionState::overlaps);
    EXPECT_EQ(plan.records[2].state, DistortionState::shown);
    EXPECT_EQ(plan.magnifiers.size(), 2u);
}

TEST(Distortion, WithholdingChangesWhatIsShownAlone) {
    Foci foci;
    foci.add(0);
    foci.add(4);
    DistortionRecords records = plan_distortion(foci.scene()).records;
    withhold(records, DistortionState::over_budget);
    EXPECT_EQ(records[0].state, DistortionState::over_budget);
    EXPECT_EQ(records[0].reach_m, 0);
    EXPECT_EQ(records[1].state, DistortionState::overlaps);
}

}  // namespace
}  // namespace tedavis::display::test_distortion
