#include "host_sim/scenario/gust_ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "host_sim/input_file.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::host_sim::test_gust_ensemble {
namespace {

Scenario shipped() {
    return parse_scenario(read_file(test_support::source_dir() + "/configs/scenarios/default.toml"), "default.toml");
}

const FlownAir kAir{101'900, 0, 6, base::radians(260)};
constexpr std::size_t kHour = std::size_t{kGustPosts} * kGustPosts;

AttributeDraft gusts(std::uint64_t seed, const Scenario& scenario = shipped()) {
    SeededRandom random(seed);
    return make_gust_layer(scenario, kAir, random).attributes[0];
}

TEST(GustEnsemble, IsTheMeanAndTheSpreadOfTheMembersThatItKeeps) {
    const AttributeDraft gust = gusts(1);
    ASSERT_EQ(gust.members.size(), 9u);
    ASSERT_EQ(gust.values.size(), kHour * kGustTimes);
    for (std::size_t post = 0; post < gust.values.size(); ++post) {
        double sum = 0, squares = 0;
        for (const std::vector<float>& member : gust.members) {
            ASSERT_GE(member[post], 0);
            sum += static_cast<double>(member[post]);
            squares += static_cast<double>(member[post]) * static_cast<double>(member[post]);
        }
        const double mean = sum / 9, spread = std::sqrt((squares - 9 * mean * mean) / 8);
        ASSERT_NEAR(static_cast<double>(gust.values[post]), mean, 1e-4);
        ASSERT_NEAR(gust.uncertainties[post].level(), std::fmin(1, spread / kFullGustSpread_mps), 1.01 / 254);
    }
}

TEST(GustEnsemble, MembersStandInTheOrderOfTheirMeansAndDiffer) {
    const AttributeDraft gust = gusts(1);
    double before = -1;
    for (const std::vector<float>& member : gust.members) {
        const double sum = std::accumulate(member.begin(), member.end(), 0.0);
        EXPECT_GT(sum, before);
        before = sum;
    }
}

/// Over many seeds: the spread that the file asks for near the strip, and more of it farther off and later.
TEST(GustEnsemble, SpreadsAsAskedAndTheMoreTheFartherAndTheLater) {
    const double asked = shipped().weather->gust.spread_mps;
    double middle = 0, corner = 0, later = 0, mean = 0;
    constexpr int kSeeds = 40;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const AttributeDraft gust = gusts(seed);
        const auto variance = [&](std::size_t post) {
            const double level = gust.uncertainties[post].level() * kFullGustSpread_mps;
            return level * level / kSeeds;
        };
        const std::size_t strip = kGustPosts / 2 * kGustPosts + kGustPosts / 2;
        middle += variance(strip), corner += variance(0), later += variance(strip + 2 * kHour);
        mean += static_cast<double>(gust.values[strip]) / kSeeds;
    }
    EXPECT_NEAR(std::sqrt(middle), asked * (1 + 1'700.0 / kGustDistance_m), 0.2 * asked) << "the post next to the strip";
    EXPECT_NEAR(mean, kGustFactor * kAir.wind_speed_mps, 0.3);
    EXPECT_GT(corner, 2 * middle);
    EXPECT_GT(later, 2 * middle);
}

TEST(GustEnsemble, IsTheSameForEqualSeedsAndEvenWithoutSpread) {
    EXPECT_EQ(gusts(3).members, gusts(3).members);
    EXPECT_NE(gusts(3).members, gusts(4).members);
    Scenario sure = shipped();
    sure.weather->gust.spread_mps = 0;
    const AttributeDraft even = gusts(3, sure);
    for (const float value : even.members[4]) EXPECT_FLOAT_EQ(value, 9);
}

}  // namespace
}  // namespace tedavis::host_sim::test_gust_ensemble
