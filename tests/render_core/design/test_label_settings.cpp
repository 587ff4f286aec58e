#include "render_core/design/label_settings.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::design::test_label_settings {
namespace {

struct Read {
    LabelSettings labels;
    std::string fault;
};
Read read(const std::string& keys) {
    const std::string text = "[labels]\n" + keys;
    base::ConfigReader reader(text, "d.toml");
    Read result;
    read_label_settings(reader.root().section("labels"), result.labels);
    if (!reader.finish()) result.fault = std::string(reader.error().message.view());
    return result;
}

TEST(LabelSettings, EveryKeyIsRead) {
    const Read whole = read(R"(distance = 2
population = 0.25
height = 0
runway_length = 3
relevance = 4
name_above = 0.5
marker_above = 0.4
dwell_s = 3
most_changes = 1
show_suppressed = true
[labels.role_relevance]
runway = 1
place = 0.1
)");
    EXPECT_EQ(whole.fault, "");
    const LabelSettings& labels = whole.labels;
    EXPECT_EQ(labels.weights.distance, 2);
    EXPECT_EQ(labels.weights.population, 0.25);
    EXPECT_EQ(labels.weights.height, 0);
    EXPECT_EQ(labels.weights.runway_length, 3);
    EXPECT_EQ(labels.weights.relevance, 4);
    EXPECT_EQ(labels.name_above, 0.5);
    EXPECT_EQ(labels.marker_above, 0.4);
    EXPECT_EQ(labels.dwell_s, 3);
    EXPECT_EQ(labels.most_changes, 1);
    EXPECT_TRUE(labels.show_suppressed);
    EXPECT_EQ(labels.relevance_of(scene::LayerRole::runway), 1);
    EXPECT_EQ(labels.relevance_of(scene::LayerRole::place), 0.1);
    EXPECT_EQ(labels.relevance_of(scene::LayerRole::obstacle), LabelSettings().relevance_of(scene::LayerRole::obstacle));
    EXPECT_EQ(labels.relevance_of(scene::LayerRole::trajectory), 0.5) << "which has no key";
}

TEST(LabelSettings, WhatMakesNoSenseIsRefused) {
    EXPECT_EQ(read("").fault, "");
    EXPECT_NE(read("marker_above = 0.6\n").fault.find("marker_above"), std::string::npos) << "above the default of names";
    EXPECT_EQ(read("marker_above = 0.6\nname_above = 0.6\n").fault, "");
    EXPECT_NE(read("distance = 0\nrelevance = 0\n").fault.find("both be 0"), std::string::npos);
    EXPECT_EQ(read("distance = 0\n").fault, "");
    EXPECT_NE(read("most_changes = 0\n").fault.find("from 0.1"), std::string::npos);
    EXPECT_NE(read("[labels.role_relevance]\ntrajectory = 1\n").fault.find("trajectory"), std::string::npos);
    EXPECT_NE(read("wieght = 1\n").fault, "");
}

}  // namespace
}  // namespace tedavis::design::test_label_settings
