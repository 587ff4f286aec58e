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

}  // namespace
}  // namespace tedavis::host_sim::test_asked_weights
