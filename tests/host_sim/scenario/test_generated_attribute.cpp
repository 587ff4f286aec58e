#include "host_sim/scenario/generated_attribute.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_generated_attribute {
namespace {

TEST(GeneratedAttribute, HoldsValuesWithTheirStandardDeviations) {
    AttributeDraft wind = generated_attribute("east", "WIND EAST", "m/s", 4);
    EXPECT_EQ(wind.uncertainty_kind, scene::UncertaintyKind::standard_deviation);
    add_value(wind, -7.5, 1);
    add_value(wind, 2, 9);
    ASSERT_EQ(wind.values.size(), 2u);
    EXPECT_EQ(wind.values[0], -7.5f);
    EXPECT_NEAR(wind.uncertainties[0].level(), 0.25, 1.0 / 254);
    EXPECT_EQ(wind.uncertainties[1].level(), 1) << "more than counts as 1";
}

TEST(GeneratedAttribute, StatesNoUncertaintyWhereThereIsNone) {
    const AttributeDraft floor = generated_attribute("floor", "FLOOR", "m", 0);
    EXPECT_EQ(floor.uncertainty_kind, scene::UncertaintyKind::none);
    EXPECT_FALSE(floor.uncertainty_all.is_known());
}

}  // namespace
}  // namespace tedavis::host_sim::test_generated_attribute
