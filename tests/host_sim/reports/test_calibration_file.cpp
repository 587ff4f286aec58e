#include "host_sim/reports/calibration_file.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tedavis::host_sim::test_calibration_file {
namespace {

MeasuredCosts measured() {
    MeasuredCosts m;
    m.subject = {"es3-mid", "llvmpipe \"quoted\" \\ (LLVM)", 1024, 768};
    m.date = "2026-11-22T22:57:48Z";
    m.design = "default";
    m.terrain = "a\nb.tdb";
    m.rounds = 9;
    double ms = 0.125;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n, ms += 0.125)
        m.costs.push_back(
            {std::string(effects::row_of(static_cast<effects::Effect>(n)).name), {ms, ms / 2, 3}, ms, 0.1, "x", ""});
    for (const std::string_view name : effects::kOverheadNames)
        m.costs.push_back({std::string(name), {1, 2, 3}, 1, 0.1, "x", ""});
    effects::EffectSet edges;
    edges.add(effects::Effect::antialiasing);
    edges.add(effects::Effect::silhouettes);
    m.candidates = {{{1, 1, {}, 40, 1, 0}, 0},
                    {{1, 1, edges, 30, 1, 0.5}, 1},
                    {{2, 0.5, {}, 45, 2, 1}, 1},
                    {{2, 0.5, edges, 20.5, 2.25, 1.25}, 1}};
    m.costs[2].note = "the view\nhas none";
    return m;
}

TEST(CalibrationFile, IsReadBackAsItWasMeasured) {
    const MeasuredCosts m = measured();
    const auto read = effects::read_calibration(calibration_toml(m), "c.toml", m.subject);
    ASSERT_TRUE(read.ok()) << read.error().message.c_str() << "\n" << calibration_toml(m);
    EXPECT_EQ(read.value().subject.renderer, m.subject.renderer);
    EXPECT_EQ(read.value().date.view(), m.date);
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        EXPECT_EQ(read.value().costs.effects[n].fixed_ms, m.costs[n].line.fixed_ms);
        EXPECT_EQ(read.value().costs.effects[n].ms_per_megapixel, m.costs[n].line.ms_per_megapixel);
    }
    const effects::QualityLevels& levels = read.value().quality;
    ASSERT_EQ(levels.count, 3u) << "one of the four is dominated";
    EXPECT_EQ(levels.at[1].ms, 30);
    EXPECT_EQ(levels.at[2].tau_factor, 2);
    EXPECT_EQ(levels.at[2].error_px, 2.25);
    EXPECT_TRUE(levels.at[2].given_up.has(effects::Effect::antialiasing));
    EXPECT_NE(calibration_toml(m).find("given_up = [\"silhouettes\", \"antialiasing\"]"), std::string::npos);
    EXPECT_NE(calibration_toml(m).find("# not measured: the view has none\n[cost.silhouettes]"), std::string::npos);
}

TEST(CalibrationFile, TheJsonSaysWhatItWasMeasuredFrom) {
    const auto json = nlohmann::json::parse(calibration_json(measured()));
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
