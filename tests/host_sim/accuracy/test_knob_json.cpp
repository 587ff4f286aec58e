#include "host_sim/accuracy/knob_json.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/whole_report.hpp"

namespace tedavis::host_sim::test_knob_json {
namespace {

TEST(KnobJson, IsReadAsItWasWritten) {
    for (const MeasuredKnob& knob : test_support::whole_report().knobs) {
        const auto json = knob_json(knob);
        EXPECT_EQ(knob_json(knob_from(json)), json) << knob.name;
    }
}

TEST(KnobJson, NamesPicturesByTheirFilesAlone) {
    const MeasuredKnob knob = test_support::whole_report().knobs[0];
    const auto json = knob_json(knob);
    EXPECT_EQ(json.at("pictures").at("files").at("cheap"), "made-cheap.png");
    const MeasuredKnob read = knob_from(json);
    ASSERT_TRUE(read.pictures);
    EXPECT_EQ(read.pictures->metric_map.file, "made-metric.png");
    EXPECT_TRUE(read.pictures->cheap.png.empty());
    EXPECT_FALSE(knob.pictures->cheap.png.empty()) << "control";
}

TEST(KnobJson, HasNullForWhatAKnobHasNot) {
    const auto json = knob_json(test_support::whole_report().knobs[0]);
    EXPECT_EQ(json.at("levels")[0].at("worst").at("pixel"), (std::vector<int>{1, 0}));
    EXPECT_TRUE(json.at("levels")[1].at("worst").at("pixel").is_null());
    EXPECT_EQ(json.at("levels")[0].at("uploaded_bytes"), 123'400);
    EXPECT_TRUE(json.at("levels")[1].at("uploaded_bytes").is_null());
}

}  // namespace
}  // namespace tedavis::host_sim::test_knob_json
