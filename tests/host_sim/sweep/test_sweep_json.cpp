#include "host_sim/sweep/sweep_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/sweep/made_sweep.hpp"

namespace tedavis::host_sim::test_sweep_json {
namespace {

using ::testing::HasSubstr;

TEST(SweepJson, HasEveryViewpoint) {
    const Sweep sweep = test_support::made_sweep();
    const auto json = sweep_json(sweep);
    EXPECT_NEAR(json["place"]["lat_deg"], 36.6, 1e-9);
    EXPECT_EQ(json["place"]["alt_msl_m"], 330);
    ASSERT_EQ(json["views"].size(), 14u);
    const auto& view = json["views"][0];
    EXPECT_EQ(view["file"], "h500_d3000_b180.png");
    EXPECT_EQ(view["bearing_deg"], 180);
    EXPECT_EQ(view["distance_m"], 3000);
    EXPECT_EQ(view["pose"]["alt_msl_m"], 830);
    EXPECT_EQ(view["hash"], "0000000000000002");
    EXPECT_EQ(view["layer_shares"]["terrain"], 0.75);
    EXPECT_EQ(view["place"]["sight"], "seen");
    EXPECT_EQ(view["place"]["rank"], 0.875);
    EXPECT_NEAR(view["place"]["times_mean"], 3, 1e-12);
    ASSERT_EQ(json["skipped"].size(), 2u);
    EXPECT_EQ(json["skipped"][1]["reason"], "outside the terrain");
    EXPECT_EQ(json["skipped"][1]["bearing_deg"], 90);
    EXPECT_EQ(json["standing_out"][0]["what"], "most clutter");
    EXPECT_EQ(json["standing_out"][0]["clutter"], 0.2);
    EXPECT_EQ(json["standing_out"][1]["subband_entropy"], 2.5);
}

TEST(SweepJson, APlaceOutsideThePictureHasNoNumbers) {
    const auto json = sweep_json(test_support::made_sweep());
    EXPECT_EQ(json["views"][3]["place"]["sight"], "outside the picture");
    for (const char* name : {"x_px", "share", "times_mean", "rank"}) EXPECT_TRUE(json["views"][3]["place"][name].is_null());
}

TEST(SweepText, HasALineAViewpoint) {
    const std::string text = sweep_text(test_support::made_sweep());
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 14 + 2);
    EXPECT_THAT(text, HasSubstr("       500        3000      180    0.150     0.000    3.0 x   88 %  seen"));
    EXPECT_THAT(text, HasSubstr("outside the picture"));
    EXPECT_THAT(text, HasSubstr("least clutter: "));
    EXPECT_THAT(text, HasSubstr("Feature Congestion 2.00, Subband Entropy 2.50 bits"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_sweep_json
