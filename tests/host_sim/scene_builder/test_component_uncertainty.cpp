#include "host_sim/scene_builder/component_uncertainty.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_component_uncertainty {
namespace {

using scene::Uncertainty;
using scene::UncertaintyKind;

constexpr UncertaintyScale kFine{UncertaintyKind::standard_deviation, 5, 0.1},
    kCoarse{UncertaintyKind::standard_deviation, 10, 0.4};

Uncertainty level(double number) { return Uncertainty::from_level(number); }

TEST(ComponentUncertainty, TheFinerScaleHoldsAndTheFasterGrowth) {
    for (const UncertaintyScale& shared : {shared_scale(kFine, kCoarse), shared_scale(kCoarse, kFine)}) {
        EXPECT_EQ(shared.kind, UncertaintyKind::standard_deviation);
        EXPECT_EQ(shared.full, 5);
        EXPECT_EQ(shared.growth_per_hour, 0.4);
    }
}

TEST(ComponentUncertainty, NeitherIsMoreCertainThanItWas) {
    const UncertaintyScale shared = shared_scale(kFine, kCoarse);
    const auto unsure = [&](Uncertainty a, Uncertainty b) { return worse_on(shared, a, kFine, b, kCoarse); };
    EXPECT_NEAR(unsure(level(0.2), level(0.4)).level() * shared.full, 4, 0.05) << "0.4 of 10, not of 5";
    EXPECT_NEAR(unsure(level(0.9), level(0.1)).level() * shared.full, 4.5, 0.05);
    EXPECT_EQ(unsure(level(0), level(1)).level(), 1) << "as unsure as can be said, or more";
    EXPECT_EQ(unsure(level(0), level(0)).level(), 0) << "control: both are certain";
    EXPECT_FALSE(unsure(Uncertainty(), level(0)).is_known());
    EXPECT_FALSE(unsure(level(0), Uncertainty()).is_known());
}

TEST(ComponentUncertainty, OfTwoKindsNobodyKnows) {
    const UncertaintyScale percent{UncertaintyKind::percent, 20, 0};
    const UncertaintyScale shared = shared_scale(kFine, percent);
    EXPECT_EQ(shared.kind, UncertaintyKind::none);
    EXPECT_FALSE(worse_on(shared, level(0), kFine, level(0), percent).is_known());
    EXPECT_TRUE(worse_on(percent, level(0), percent, level(0), percent).is_known()) << "control";
}

TEST(ComponentUncertainty, ClassesAreLevelsWhateverTheirNumber) {
    const UncertaintyScale three{UncertaintyKind::ordinal, 2, 0}, five{UncertaintyKind::ordinal, 4, 0};
    EXPECT_EQ(worse_on(shared_scale(three, five), level(0), three, level(0.5), five), level(0.5));
}

}  // namespace
}  // namespace tedavis::host_sim::test_component_uncertainty
