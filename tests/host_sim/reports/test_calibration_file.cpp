#include "host_sim/reports/calibration_file.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/flights/measured_costs.hpp"

namespace tedavis::host_sim::test_calibration_file {
namespace {

TEST(CalibrationFile, TheJsonSaysWhatItWasMeasuredFrom) {
    const auto json = nlohmann::json::parse(calibration_json(test_support::measured_costs()));
    EXPECT_EQ(json["device"], "es3-mid");
    EXPECT_EQ(json["size"], "1024x768");
    EXPECT_EQ(json["rounds"], 9);
    EXPECT_EQ(json["costs"].size(), effects::kEffectCount + effects::kOverheads);
    EXPECT_EQ(json["costs"][0]["name"], "terrain");
    EXPECT_EQ(json["costs"][0]["spread_ms"], 0.1);
    ASSERT_EQ(json["quality"].size(), 4u);
    EXPECT_EQ(json["quality"][1]["level"], 1);
    EXPECT_TRUE(json["quality"][2]["level"].is_null()) << "measured, and not chosen";
    EXPECT_EQ(json["quality"][3]["given_up"].size(), 2u);
    EXPECT_EQ(json["costs"][2]["note"], "the view\nhas none");
}

}  // namespace
}  // namespace tedavis::host_sim::test_calibration_file
