#include "host_sim/options/asked_weights.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_asked_weights {
namespace {

using test_support::expect_user_error;

TEST(AskedWeights, AreReadAndWrittenAlike) {
    const AskedWeights weights = weights_from("terrain=0.25,data=1");
    EXPECT_EQ(weights, (AskedWeights{{"terrain", 0.25}, {"data", 1}}));
    EXPECT_EQ(weights_from(text_of(weights)), weights);
    for (const char* wrong :
         {"", "terrain", "=1", "terrain=", "terrain=2", "terrain=-0.1", "terrain=nan", "terrain=1x", "terrain=1,,data=1"})
        expect_user_error([&] { static_cast<void>(weights_from(wrong)); }, "names with numbers from 0 to 1");
    expect_user_error([] { static_cast<void>(weights_from("terrain=1,terrain=0.5")); }, "'terrain' has two weights");
}

TEST(AskedWeights, StandAboveTheDesigns) {
    design::PrioritySettings priority;
    put_weights({}, "d.toml", priority);
    EXPECT_FALSE(priority.is_stated) << "nothing was asked";
    design::DataPart part;
    part.name = "obstacles";
    priority.weights.of[design::kMainAspects] = 0.9;
    ASSERT_TRUE(priority.parts.try_push_back(part));
    put_weights({{"obstacles", 0.2}, {"terrain", 0.1}}, "d.toml", priority);
    EXPECT_TRUE(priority.is_stated);
    EXPECT_EQ(priority.weights.of[design::kTerrainAspect], 0.1);
    EXPECT_EQ(priority.weights.of[design::kDataAspect], 1);
    EXPECT_EQ(priority.weights.of[design::kMainAspects], 0.2);
    expect_user_error(
        [&] {
            put_weights({{"streets", 1}}, "d.toml", priority);
        },
        "d.toml: has no aspect 'streets' to weigh; it has terrain, data, uncertainty, obstacles");
}

}  // namespace
}  // namespace tedavis::host_sim::test_asked_weights
