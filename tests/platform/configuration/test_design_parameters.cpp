#include "platform/configuration/design_parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::platform::test_design_parameters {
namespace {

using ::testing::HasSubstr;

DesignParameters weighed(std::initializer_list<AspectWeight> weights) {
    DesignParameters parameters;
    for (const AspectWeight& weight : weights) EXPECT_TRUE(parameters.weights.try_push_back(weight));
    return parameters;
}

TEST(DesignParameters, StandAboveTheDesigns) {
    design::DesignSettings design;
    const double own = design.terrain.tau_px;
    EXPECT_FALSE(put_parameters({}, "d.toml", design));
    EXPECT_FALSE(design.priority.is_stated) << "nothing was asked";
    EXPECT_EQ(design.terrain.tau_px, own);
    design::DataPart part;
    part.name = "obstacles";
    design.priority.weights.of[design::kMainAspects] = 0.9;
    ASSERT_TRUE(design.priority.parts.try_push_back(part));
    DesignParameters asked = weighed({{"obstacles", 0.2}, {"terrain", 0.1}});
    asked.tau_px = 3.5;
    EXPECT_FALSE(put_parameters(asked, "d.toml", design));
    EXPECT_TRUE(design.priority.is_stated);
    EXPECT_EQ(design.priority.weights.of[design::kTerrainAspect], 0.1);
    EXPECT_EQ(design.priority.weights.of[design::kDataAspect], 1);
    EXPECT_EQ(design.priority.weights.of[design::kMainAspects], 0.2);
    EXPECT_EQ(design.terrain.tau_px, 3.5);
    EXPECT_THAT(put_parameters(weighed({{"streets", 1}}), "d.toml", design).message.c_str(),
                HasSubstr("d.toml: has no aspect 'streets' to weigh; it has terrain, data, uncertainty, obstacles"));
}

TEST(DesignParameters, FociComeBeforeTheDesigns) {
    design::DesignSettings design;
    DesignParameters asked;
    ASSERT_TRUE(asked.foci.try_push_back("shape = \"circle\", at = \"place\", place = \"DAVOS\", terrain.brightness = 0.5"));
    ASSERT_EQ(put_parameters(asked, "d.toml", design).message.view(), "");
    ASSERT_EQ(put_parameters(asked, "d.toml", design).message.view(), "");
    EXPECT_EQ(design.foci.size(), 2u);
    for (int n = 0; n < 2; ++n) ASSERT_FALSE(put_parameters(asked, "d.toml", design));
    EXPECT_THAT(put_parameters(asked, "d.toml", design).message.c_str(), HasSubstr("has room for 4 foci"));
    asked.foci.clear();
    ASSERT_TRUE(asked.foci.try_push_back("shape = \"star\""));
    design = {};
    EXPECT_THAT(put_parameters(asked, "d.toml", design).message.c_str(), HasSubstr("it is 'shape = \"star\"'"));
}

}  // namespace
}  // namespace tedavis::platform::test_design_parameters
