#include "host_sim/evaluation/clutter_peaks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tedavis::host_sim::test_clutter_peaks {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<double> seconds(std::size_t count) {
    std::vector<double> times;
    for (std::size_t n = 0; n < count; ++n) times.push_back(static_cast<double>(n));
    return times;
}

std::vector<std::size_t> places(const std::vector<double>& values, const PeakRule& rule) {
    std::vector<std::size_t> indices;
    for (const Peak& peak : find_peaks(seconds(values.size()), values, rule)) indices.push_back(peak.index);
    return indices;
}

const PeakRule kAll{1e-9, 0, 1000};

TEST(ClutterPeaks, ProminenceIsTheDropToTheHigherValley) {
    const std::vector<double> values{0, 5, 2, 3, 1, 9, 0};
    const std::vector<Peak> peaks = find_peaks(seconds(7), values, kAll);
    ASSERT_EQ(peaks.size(), 3u);
    EXPECT_EQ(peaks[0].prominence, 4) << "5 over the 1 before the 9";
    EXPECT_EQ(peaks[1].prominence, 1) << "3 over the 2 before the 5";
    EXPECT_EQ(peaks[2].prominence, 9);
    EXPECT_THAT(places(values, {2, 0, 10}), ElementsAre(1, 5));
}

TEST(ClutterPeaks, EndsPlateausAndFlatCurves) {
    EXPECT_THAT(places({3, 1, 2}, kAll), ElementsAre(0, 2));
    EXPECT_THAT(places({0, 4, 4, 4, 0}, kAll), ElementsAre(2)) << "the middle of a plateau";
    EXPECT_THAT(places({0, 4, 4, 5, 0}, kAll), ElementsAre(3)) << "a step on the way up is none";
    EXPECT_THAT(places({2, 2, 2}, kAll), IsEmpty());
    EXPECT_THAT(places({2}, kAll), IsEmpty());
    EXPECT_THAT(places({}, kAll), IsEmpty());
}

TEST(ClutterPeaks, TheHigherOfTwoNeighboursStays) {
    EXPECT_THAT(places({0, 5, 0, 6, 0, 0, 5, 0}, {1, 3, 10}), ElementsAre(3, 6));
    EXPECT_THAT(places({0, 5, 0, 5, 0}, {1, 3, 10}), ElementsAre(1)) << "of equal ones the earlier";
    EXPECT_THAT(places({0, 5, 0, 6, 0, 3, 0}, {1, 0, 2}), ElementsAre(1, 3)) << "the most prominent ones";
}

TEST(ClutterPeaks, ShippedRuleLeavesJitterAlone) {
    std::vector<double> values;
    std::mt19937 random(7);
    for (std::size_t n = 0; n < 400; ++n) {
        const double jitter = 0.002 * (static_cast<double>(random() % 1000) / 1000 - 0.5);
        values.push_back(0.2 + jitter + (n > 195 && n < 205 ? 0.05 : 0));
    }
    const std::vector<Peak> peaks = find_peaks(seconds(400), values, peak_rule_for(seconds(400), values));
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_NEAR(static_cast<double>(peaks[0].index), 200, 5);
    for (double& value : values) value = 0.2 + (value - 0.2) * 0.05;
    EXPECT_THAT(places(values, peak_rule_for(seconds(400), values)), IsEmpty()) << "nothing rises by half a per cent";
}

// Against the definition, walked in another way: prominence is the height over the best col to higher ground.
TEST(ClutterPeaks, AgreesWithTheDefinitionOnRandomCurves) {
    std::mt19937 random(11);
    for (int round = 0; round < 50; ++round) {
        std::vector<double> values(60);
        for (double& value : values) value = static_cast<double>(random() % 100000);
        for (const Peak& peak : find_peaks(seconds(60), values, kAll)) {
            std::vector<double> sides;
            for (const int step : {-1, 1}) {
                double lowest = values[peak.index];
                int at = static_cast<int>(peak.index) + step;
                if (at < 0 || at >= 60) continue;
                for (; at >= 0 && at < 60 && values[static_cast<std::size_t>(at)] <= values[peak.index]; at += step)
                    lowest = std::min(lowest, values[static_cast<std::size_t>(at)]);
                sides.push_back(lowest);
            }
            EXPECT_EQ(peak.prominence, values[peak.index] - *std::max_element(sides.begin(), sides.end()));
        }
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_clutter_peaks
