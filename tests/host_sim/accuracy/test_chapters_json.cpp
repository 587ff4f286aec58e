#include "host_sim/accuracy/chapters_json.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/whole_report.hpp"

namespace tedavis::host_sim::test_chapters_json {
namespace {

TEST(ChaptersJson, AreReadAsTheyWereWritten) {
    const AccuracyReport report = test_support::whole_report();
    const auto flight = flight_json(report.flights[0]);
    EXPECT_EQ(flight_json(flight_from(flight)), flight);
    const auto uncalled = uncalled_json(report.uncalled);
    EXPECT_EQ(uncalled_json(uncalled_from(uncalled)), uncalled);
    const auto control = control_json(report.control);
    EXPECT_EQ(control_json(control_from(control)), control);
    const auto compared = compared_json(report.comparisons[0]);
    EXPECT_EQ(compared_json(compared_from(compared)), compared);
    EXPECT_EQ(flight.at("lines")[0].at("broken"), 2);
    EXPECT_EQ(uncalled.at("effects")[0].at("reasons")[0].at("why"), "nothing near");
    EXPECT_EQ(compared.at("levels")[0].at("less_accurate"), true);
}

TEST(ChaptersJson, AreNullWhereNothingWasMeasured) {
    EXPECT_TRUE(uncalled_json(std::nullopt).is_null());
    EXPECT_FALSE(uncalled_from(nullptr));
    EXPECT_TRUE(control_json(std::nullopt).is_null());
    EXPECT_FALSE(control_from(nullptr));
}

}  // namespace
}  // namespace tedavis::host_sim::test_chapters_json
