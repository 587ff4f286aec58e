#include "platform/runtime/cost_bench.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/platform/runtime/modelled_bench.hpp"

namespace tedavis::platform::test_cost_bench {
namespace {

using effects::Effect;
using effects::MeasuredCost;

struct CostBenchTest : testing::Test {
    std::string measure() {
        return std::string(std::make_unique<CostBench>(bench, ModelledBench::place(), 3)->measure(*measured).message.view());
    }
    [[nodiscard]] const MeasuredCost& cost(std::string_view name) const {
        for (const MeasuredCost& one : measured->costs)
            if (one.name.view() == name) return one;
        ADD_FAILURE() << name;
        return measured->costs[0];
    }
    ModelledBench bench;
    std::unique_ptr<effects::MeasuredCosts> measured = std::make_unique<effects::MeasuredCosts>();
};

/// The model is the oracle: what the bench finds is what the frames were given.
TEST_F(CostBenchTest, FindsWhatTheModelCosts) {
    ASSERT_EQ(measure(), "");
    ASSERT_EQ(measured->costs.size(), effects::kEffectCount + effects::kOverheads);
    constexpr double kMegapixels = ModelledBench::kWidth * ModelledBench::kHeight / 1e6;
    EXPECT_NEAR(cost("terrain").line.ms_per_thousand, bench.costs.ms_per_thousand_triangles, 0.01);
    EXPECT_NEAR(cost("terrain").line.ms_per_megapixel * kMegapixels, 0, 0.01);
    EXPECT_NEAR(cost("frame").line.fixed_ms, bench.costs.frame_ms, 1e-3);
    EXPECT_NEAR(cost("antialiasing").line.ms_per_megapixel * kMegapixels, bench.costs.antialiasing_ms, 1e-3);
    EXPECT_EQ(cost("rays").note.view(), "");
    EXPECT_NEAR(cost("rays").line.ms_per_megapixel * kMegapixels, bench.costs.rays_ms, 1e-3);
    EXPECT_EQ(cost("haze").note.view(), "");
    EXPECT_NEAR(cost("haze").ms, 0, 1e-3) << "control: runs, and costs nothing in the model";
    EXPECT_EQ(cost("saliency").note.view(), "not asked for here");
    EXPECT_EQ(cost("saliency").line.ms_per_megapixel, 0);
    EXPECT_EQ(cost("glyphs").note.view(), "no field of glyphs is in view");
    EXPECT_EQ(bench.steps, bench.of_steps);
    EXPECT_EQ(measured->subject.device.view(), "es3-mid");
    effects::CalibrationText text;
    write_calibration(*measured, text);
    const auto read = effects::read_calibration(text.view(), "c.toml", measured->subject);
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    EXPECT_GE(read.value().quality.count, 2u) << "antialiasing can be given up";
}

TEST_F(CostBenchTest, FaultsAreOneSentence) {
    bench.stopped_at = 20;
    EXPECT_EQ(measure(), "interrupted; nothing was written");
    bench.terrain = "/nowhere.tdb";
    EXPECT_NE(measure().find("/nowhere.tdb: cannot be read"), std::string::npos);
}

TEST_F(CostBenchTest, ADeviceThatTracesNothingSaysWhy) {
    bench.device = test_support::shipped_device("es2-small");
    ASSERT_EQ(measure(), "");
    EXPECT_EQ(cost("rays").note.view(), "the device's lane is es2");
    EXPECT_EQ(cost("rays").line.ms_per_megapixel, 0);
}

TEST(AsksFor, KnowsSettingsOfOtherEffects) {
    design::DesignSettings design;
    design.warning_colors = false;
    design.terrain.style.sketch.ridges = 0;
    EXPECT_FALSE(asks_for(design, Effect::warning_colors));
    EXPECT_FALSE(asks_for(design, Effect::ridges));
    design.warning_colors = true;
    design.terrain.style.sketch.ridges = 0.5;
    EXPECT_TRUE(asks_for(design, Effect::warning_colors));
    EXPECT_TRUE(asks_for(design, Effect::ridges));
    EXPECT_FALSE(asks_for(design, Effect::antialiasing));
    EXPECT_TRUE(asks_for(effects::with_effect(design, Effect::antialiasing), Effect::antialiasing));
}

}  // namespace
}  // namespace tedavis::platform::test_cost_bench
