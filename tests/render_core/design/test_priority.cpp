#include "render_core/design/priority.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::design::test_priority {
namespace {

using scene::LayerRole;

PrioritySettings read(const std::string& text, std::string* fault = nullptr) {
    base::ConfigReader reader(text, "design.toml");
    PrioritySettings priority;
    base::ConfigSection root = reader.root();
    read_priority(root.section("priority"), priority);
    const bool is_whole = reader.finish();
    const std::string said = is_whole ? "" : std::string(reader.error().message.view());
    if (fault != nullptr)
        *fault = said;
    else
        EXPECT_EQ(said, "");
    return priority;
}

TEST(Priority, WithoutTheSectionNothingIsWeighed) {
    const PrioritySettings priority = read("");
    EXPECT_FALSE(priority.is_stated);
    EXPECT_TRUE(priority.weights == AspectWeights());
    EXPECT_EQ(priority.count(), kMainAspects);
}

TEST(Priority, PartsOfTheDataHaveWeightsOfTheirOwn) {
    const PrioritySettings priority = read(
        "[priority]\nterrain = 0.2\ndata = 0.7\n[[priority.aspect]]\nname = \"streets\"\n"
        "roles = [\"road\", \"river\"]\nweight = 0.4\n[[priority.aspect]]\nname = \"weather\"\n"
        "roles = [\"storm_cell\", \"river\"]\nweight = 0.9\nhazard = true\n");
    ASSERT_EQ(priority.count(), 5u);
    EXPECT_EQ(priority.weights.of[kTerrainAspect], 0.2);
    EXPECT_EQ(priority.weights.of[kUncertaintyAspect], 1);
    EXPECT_EQ(priority.weights.of[priority.aspect_of(LayerRole::road)], 0.4);
    EXPECT_EQ(priority.weights.of[priority.aspect_of(LayerRole::river)], 0.4) << "the first part that has it";
    EXPECT_EQ(priority.weights.of[priority.aspect_of(LayerRole::storm_cell)], 0.9);
    EXPECT_EQ(priority.aspect_of(LayerRole::wind), kDataAspect);
    EXPECT_EQ(priority.name_of(0), "terrain");
    EXPECT_EQ(priority.name_of(4), "weather");
    EXPECT_TRUE(priority.parts[1].is_hazard);
}

TEST(Priority, CurvesAreLinearBetweenTheirKnotsAndLevelBeyond) {
    const DetailCurve curve = read("[priority]\n[priority.detail]\nshading = [0.2, 0.1, 0.4, 0.5, 0.8, 1]\n").shading;
    EXPECT_DOUBLE_EQ(curve.at(0), 0.1);
    EXPECT_DOUBLE_EQ(curve.at(0.2), 0.1);
    EXPECT_NEAR(curve.at(0.3), 0.3, 1e-12);
    EXPECT_NEAR(curve.at(0.6), 0.75, 1e-12);
    EXPECT_DOUBLE_EQ(curve.at(1), 1);
    for (const double weight : {0.0, 0.25, 1.0}) EXPECT_EQ(DetailCurve().at(weight), weight);
    for (double weight = 0; weight < 1; weight += 0.01) EXPECT_LE(curve.at(weight), curve.at(weight + 0.01) + 1e-12);
}

TEST(Priority, WhatIsWrongIsSaid) {
    const struct {
        const char *text, *said;
    } kWrong[] = {
        {"[priority.detail]\ndata = [0.2, 0.1, 0.4]\n", "pairs"},
        {"[priority.detail]\ndata = [0.4, 0.1, 0.4, 0.2]\n", "ascending"},
        {"[[priority.aspect]]\nname = \"a\"\nroles = [\"rodes\"]\nweight = 1\n",
         "'rodes', which is no role of layers; roles are"},
        {"[[priority.aspect]]\nname = \"a\"\nroles = []\nweight = 1\n", "at least one"},
        {"[[priority.aspect]]\nname = \"\"\nroles = [\"road\"]\nweight = 1\n", "1 to 23"},
        {"[priority]\nterrain = 1.5\n", "terrain"},
        {"[[priority.aspect]]\nname = \"terrain\"\nroles = [\"road\"]\nweight = 1\n", "is taken"},
    };
    for (const auto& wrong : kWrong) {
        std::string fault;
        static_cast<void>(read(wrong.text, &fault));
        EXPECT_NE(fault.find(wrong.said), std::string::npos) << wrong.text << fault;
    }
    std::string six = "[priority]\n", fault;
    for (int n = 0; n < 6; ++n)
        six += "[[priority.aspect]]\nname = \"a" + std::to_string(n) + "\"\nroles = [\"road\"]\nweight = 1\n";
    static_cast<void>(read(six, &fault));
    EXPECT_NE(fault.find("more than 5"), std::string::npos) << fault;
}

}  // namespace
}  // namespace tedavis::design::test_priority
