#include "host_sim/replay/pose_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/replay/posed_frame.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_pose_findings {
namespace {

using ::testing::HasSubstr;

Findings of_pose(const AircraftPose& pose, bool has_terrain = true) {
    static const test_support::FlownFiles kFiles;
    PictureOptions options = kFiles.options("unused").picture;
    if (!has_terrain) options.terrain.clear();
    DisplaySession session(options, false);
    const FrameResult result = posed_frame(session, pose, {});
    return pose_findings(pose, result.record, "X.tdb", session.display());
}

constexpr AircraftPose kSound{47.03, 9.68, 2500, 40, -6, 12};

TEST(PoseFindings, APoseOverTerrainHasNone) {
    EXPECT_TRUE(of_pose(kSound).empty());
    EXPECT_TRUE(of_pose({0, 0, 0, 0, 0, 0}, false).empty()) << "there is no terrain to be wrong about";
}

TEST(PoseFindings, LatitudeAndLongitudeExchangedAreToldApart) {
    const Findings swapped = of_pose({9.68, 47.03, 2500, 40, -6, 12});
    ASSERT_EQ(swapped.size(), 1u);
    EXPECT_EQ(swapped[0].name, "terrain.outside");
    EXPECT_THAT(swapped[0].text, HasSubstr("the pose 9.6800,47.0300 lies outside X.tdb, which covers "));
    EXPECT_THAT(swapped[0].text, HasSubstr("with latitude and longitude exchanged it lies inside, so write 47.0300,9.6800"));
    const Findings elsewhere = of_pose({-30, 140, 2500, 40, -6, 12});
    ASSERT_EQ(elsewhere.size(), 1u);
    EXPECT_THAT(elsewhere[0].text, ::testing::Not(HasSubstr("exchanged")));
}

TEST(PoseFindings, APoseBelowTheGroundSaysHowDeep) {
    AircraftPose low = kSound;
    low.altitude_msl_m = -400;
    const Findings findings = of_pose(low);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].name, "terrain.above_own_ship");
    EXPECT_THAT(findings[0].text, HasSubstr(" m below the ground of X.tdb, which is "));
}

TEST(PoseFindings, AViewWithoutTerrainIsSaid) {
    AircraftPose up = kSound;
    up.pitch_deg = 80;
    up.roll_deg = 0;
    const Findings findings = of_pose(up);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].name, "terrain.not_in_view");
}

}  // namespace
}  // namespace tedavis::host_sim::test_pose_findings
