#include "render_core/effects/calibration_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/flights/measured_costs.hpp"

namespace tedavis::effects::test_calibration_text {
namespace {

std::string text_of(const MeasuredCosts& measured) {
    CalibrationText text;
    write_calibration(measured, text);
    EXPECT_FALSE(text.cut());
    return std::string(text.view());
}

TEST(CalibrationText, IsReadBackAsItWasMeasured) {
    const MeasuredCosts m = test_support::measured_costs();
    const std::string text = text_of(m);
    const auto read = read_calibration(text, "c.toml", m.subject);
    ASSERT_TRUE(read.ok()) << read.error().message.c_str() << "\n" << text;
    EXPECT_EQ(read.value().subject.renderer, m.subject.renderer);
    EXPECT_EQ(read.value().date, m.date);
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        EXPECT_EQ(read.value().costs.effects[n].fixed_ms, m.costs[n].line.fixed_ms);
        EXPECT_EQ(read.value().costs.effects[n].ms_per_megapixel, m.costs[n].line.ms_per_megapixel);
    }
    const QualityLevels& levels = read.value().quality;
    ASSERT_EQ(levels.count, 3u) << "one of the four is dominated";
    EXPECT_EQ(levels.at[1].ms, 30);
    EXPECT_EQ(levels.at[2].tau_factor, 2);
    EXPECT_EQ(levels.at[2].error_px, 2.25);
    EXPECT_TRUE(levels.at[2].given_up.has(Effect::antialiasing));
    EXPECT_NE(text.find("given_up = [\"silhouettes\", \"antialiasing\"]"), std::string::npos);
    EXPECT_NE(text.find("# not measured: the view has none\n[cost.silhouettes]"), std::string::npos);
    EXPECT_EQ(text.find("# What everything costs on one display, by tedavis calibrate, over a b.tdb with the design default.\n"),
              0u);
}

/// A control: what stands in the file is what the reader reads.
TEST(CalibrationText, ACostThatWasNotWrittenIsMissed) {
    MeasuredCosts m = test_support::measured_costs();
    m.costs.pop_back();
    const auto without_rays = read_calibration(text_of(m), "c.toml");
    ASSERT_TRUE(without_rays.ok()) << "as older files are";
    EXPECT_FALSE(without_rays.value().costs.knows_rays());
    m.costs.pop_back();
    const auto read = read_calibration(text_of(m), "c.toml");
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().message.view().find("the cost of 'glyphs' is missing"), std::string_view::npos);
}

TEST(CalibrationText, TheLongestFileIsNotCut) {
    MeasuredCosts m = test_support::measured_costs();
    const std::string longest(2000, '"');
    m.subject.device.clear();
    m.subject.renderer.clear();
    m.subject.device.append(longest);
    m.subject.renderer.append(longest);
    for (auto* const text : {&m.design, &m.terrain}) text->append(longest);
    for (MeasuredCost& cost : m.costs) {
        cost.note.append(longest);
        cost.line = {999999.123456, 999999.123456, 999999.123456};
    }
    m.candidates.clear();
    EffectSet every;
    for (std::size_t n = 0; n < kEffectCount; ++n)
        if (row_of(static_cast<Effect>(n)).may_be_given_up) every.add(static_cast<Effect>(n));
    for (std::size_t n = 0; n < kMaxQualityCandidates; ++n) {
        const double more = static_cast<double>(n);
        static_cast<void>(
            m.candidates.try_push_back({{1 + more, 1, n == 0 ? EffectSet() : every, 100 - more, 1 + more, more}, 0}));
    }
    ASSERT_EQ(choose_levels(m.candidates).count, kQualityLevelCount);
    EXPECT_TRUE(read_calibration(text_of(m), "c.toml").ok());
}

}  // namespace
}  // namespace tedavis::effects::test_calibration_text
