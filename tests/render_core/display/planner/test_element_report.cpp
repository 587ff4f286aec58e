#include "render_core/display/planner/element_report.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace tedavis::display::test_element_report {
namespace {

using design::DataTechnique;

TEST(ElementReport, EveryStateHasItsOwnReason) {
    std::set<std::string_view> reasons;
    for (std::size_t n = 0; n <= static_cast<std::size_t>(ElementState::no_terrain); ++n)
        EXPECT_TRUE(reasons.insert(reason_of(static_cast<ElementState>(n))).second) << n;
    EXPECT_EQ(reasons.count("unknown"), 0u);
}

TEST(ElementReport, SignsStandOverThePicture) {
    for (const DataTechnique technique : {DataTechnique::billboard, DataTechnique::diagram}) {
        EXPECT_TRUE(is_billboard_technique(technique));
        EXPECT_TRUE(is_sign_technique(technique));
    }
    EXPECT_TRUE(is_sign_technique(DataTechnique::barbs));
    EXPECT_FALSE(is_billboard_technique(DataTechnique::barbs));
    EXPECT_FALSE(is_sign_technique(DataTechnique::tube));
}

TEST(ElementReport, OneThatIsOutOfDateIsEnough) {
    ElementReports reports;
    ElementReport report;
    report.state = ElementState::shown;
    ASSERT_TRUE(reports.try_push_back(report));
    EXPECT_FALSE(any_is_out_of_date(reports));
    report.state = ElementState::out_of_date;
    ASSERT_TRUE(reports.try_push_back(report));
    EXPECT_TRUE(any_is_out_of_date(reports));
}

}  // namespace
}  // namespace tedavis::display::test_element_report
