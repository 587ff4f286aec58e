#include "host_sim/evaluation/plan_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_plan_lines {
namespace {

std::string words_of(const PlanLines& lines, const std::string& term) {
    for (const auto& [name, words] : lines)
        if (name == term) return words;
    return "none";
}

TEST(PlanLines, TellWhatARecordHolds) {
    FrameResult result = test_support::frame_result(3, 1.5);
    result.record.design = display::Name("cruise");
    result.record.terrain_aspect.technique = base::FixedString<95>("plain_sketch");
    result.record.terrain_aspect.weight = 0.25f;
    result.record.labels.placed = 4;
    result.record.labels.suppressed = 7;
    EXPECT_TRUE(result.record.flags.try_push_back(display::Name("altitude.stale")));
    const PlanLines lines = plan_lines(nlohmann::ordered_json::parse(frame_record_json(result, base::Time{0})));
    EXPECT_EQ(words_of(lines, "design"), "cruise");
    EXPECT_THAT(words_of(lines, "weights"), ::testing::HasSubstr("terrain 0.25, data "));
    EXPECT_THAT(words_of(lines, "terrain"), ::testing::HasSubstr("plain sketch, 12345 triangles"));
    EXPECT_EQ(words_of(lines, "labels"), "4 placed, 7 suppressed");
    EXPECT_EQ(words_of(lines, "flags"), "altitude.stale");
    EXPECT_EQ(words_of(lines, "own ship"), "1510 m MSL, heading 270°, pitch 5°, roll -10°");
}

TEST(PlanLines, DataAndEffectsAreCountedAndNamed) {
    const auto record = nlohmann::ordered_json::parse(R"({
        "data": {"wind": {"drawn": 68, "aggregated": 2, "hidden": 330, "out_of_view": 9}, "no_go": {"drawn": 2, "hidden": 0},
                 "place": {"drawn": 0, "hidden": 0, "out_of_view": 5}},
        "effects": [{"name": "haze", "state": "run"}, {"name": "data.solid", "state": "run"}, {"name": "haze", "state": "run"},
                    {"name": "soft_shadows", "state": "replaced", "replaced_by": "shade"}, {"name": "fog", "state": "skipped"}],
        "foci": [{"name": "HERE", "shown": true}, {"name": "THERE", "shown": false}],
        "labels": {"placed": 3, "suppressed": 1, "decluttered": 2},
        "clutter": {"budget": 0.1, "decluttered_roles": ["wind", "place"], "regions": [{"detail": 0.5}, {"detail": 1.0}, {"detail": 0.25}]},
        "own_ship": {"alt_msl_m": 10.2, "heading_deg": 1, "pitch_deg": -0.2, "roll_deg": 0}})");
    const PlanLines lines = plan_lines(record);
    EXPECT_EQ(words_of(lines, "data drawn"), "wind 68 of 400, no go 2");
    EXPECT_EQ(words_of(lines, "effects run"), "haze");
    EXPECT_EQ(words_of(lines, "replaced"), "soft shadows by shade");
    EXPECT_EQ(words_of(lines, "gives way"), "wind, place in 2 regions; 2 signs");
    EXPECT_EQ(words_of(lines, "foci"), "HERE");
    EXPECT_EQ(words_of(lines, "own ship"), "10 m MSL, heading 1°, pitch 0°, roll 0°") << "no minus before zero";
}

TEST(PlanLines, WhatIsMissingIsLeftOut) {
    EXPECT_TRUE(plan_lines(nlohmann::ordered_json::object()).empty());
    EXPECT_TRUE(
        plan_lines(nlohmann::ordered_json::parse(R"({"presentation": 3, "data": [], "effects": {}, "foci": 1, "clutter": null})"))
            .empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_plan_lines
