#include "host_sim/accuracy/knobs/effect_knobs.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_effect_knobs {
namespace {

/// Mean errors of all levels, each of which must be below that of the level before.
std::vector<double> falling_means(Knob& knob) {
    std::vector<double> means;
    for (std::size_t level = 0; level < knob.facts().levels.size(); ++level) {
        means.push_back(test_support::errors_of(knob, level).mean);
    }
    for (std::size_t level = 1; level < means.size(); ++level)
        EXPECT_LT(means[level], means[level - 1]) << knob.facts().levels[level].name.text();
    return means;
}

class EffectKnobs : public ::testing::Test {
protected:
    static void SetUpTestSuite() { shipped_ = new test_support::ShippedKnobGround; }
    static void TearDownTestSuite() { delete shipped_; }
    static test_support::ShippedKnobGround* shipped_;
};
test_support::ShippedKnobGround* EffectKnobs::shipped_ = nullptr;

TEST_F(EffectKnobs, AFinerMapOfShadowsIsNearerToTheFinestAndLarger) {
    const auto knob = make_shadow_map_knob(shipped_->quick());
    const std::vector<double> means = falling_means(*knob);
    EXPECT_LT(means.back(), 0.2 * means.front());
    EXPECT_GT(means.front(), 10 * knob->facts().reference.error_bound()) << "control: shadows are in the pictures";
    EXPECT_EQ(knob->bytes(0), 32u * 32 * 8 * 3);
}

TEST_F(EffectKnobs, MoreStepsThroughTheAirAreNearerToVeryMany) {
    const auto knob = make_shaft_steps_knob(shipped_->quick());
    const std::vector<double> means = falling_means(*knob);
    EXPECT_LT(means.back(), 0.5 * means.front());
    EXPECT_GT(means.front(), 10 * knob->facts().reference.error_bound()) << "control: there are shafts in the pictures";
}

TEST_F(EffectKnobs, MorePlacesOfABlurAreNearerToVeryMany) {
    const auto knob = make_blur_taps_knob(shipped_->quick());
    const std::vector<double> means = falling_means(*knob);
    EXPECT_LT(means.back(), 0.4 * means.front());
    EXPECT_GT(means.front(), 10 * knob->facts().reference.error_bound()) << "control: the pictures are blurred";
}

TEST_F(EffectKnobs, MoreStepsOfAContextAreNearerToNone) {
    const auto knob = make_focus_levels_knob(shipped_->quick());
    const std::vector<double> means = falling_means(*knob);
    EXPECT_GT(means.front(), 0.2) << "control: the context is in the pictures";
    const FittedLaw law = fit_law(test_support::points_of(*knob, means));
    EXPECT_TRUE(law.holds);
    EXPECT_NEAR(law.exponent, -1, 0.25);
}

TEST_F(EffectKnobs, FewerPagesOfMapsShowCoarserOnes) {
    const auto knob = make_map_pages_knob(shipped_->quick());
    const std::vector<double> means = falling_means(*knob);
    EXPECT_EQ(means.back(), 0);
    EXPECT_GT(means.front(), 0.1) << "control";
    EXPECT_LT(knob->bytes(0), knob->bytes(1));
}

}  // namespace
}  // namespace tedavis::host_sim::test_effect_knobs
