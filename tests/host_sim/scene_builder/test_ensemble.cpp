#include "host_sim/scene_builder/ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tedavis::host_sim::test_ensemble {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

TEST(Ensemble, HasTheMeanAndTheSpreadOfItsMembers) {
    const EnsembleMean joined = mean_of({{1, 10, 3}, {2, 10, kMissing}, {6, 10, 5}});
    EXPECT_EQ(joined.mean[0], 3);
    EXPECT_FLOAT_EQ(joined.spread[0], std::sqrt(7.0F)) << "(4 + 1 + 9) / 2";
    EXPECT_EQ(joined.spread[1], 0);
    EXPECT_TRUE(std::isnan(joined.mean[2])) << "a mean of some is none";
    EXPECT_EQ(mean_of({{4}}).mean[0], 4);
    EXPECT_TRUE(std::isnan(mean_of({{4}}).spread[0])) << "one alone says nothing of its spread";
}

TEST(Ensemble, SumsLeaveOutPostsThatNotAllHave) {
    std::vector<double> sums;
    add_to_sums({{1, 100}, {2, kMissing}}, sums);
    add_to_sums({{10}, {20}}, sums);
    EXPECT_EQ(sums, (std::vector<double>{11, 22}));
}

TEST(Ensemble, KeepsMembersEvenlyByRank) {
    using Numbers = std::vector<std::size_t>;
    const std::vector<double> sums = {50, 10, 40, 0, 30, 20};  // ranks 5, 1, 4, 0, 3, 2
    EXPECT_EQ(evenly_by_rank(sums, 2), (Numbers{3, 0})) << "the lowest and the highest";
    EXPECT_EQ(evenly_by_rank(sums, 3), (Numbers{3, 4, 0})) << "of two in the middle the upper one";
    EXPECT_EQ(evenly_by_rank(sums, 6), (Numbers{3, 1, 5, 4, 2, 0}));
    EXPECT_EQ(evenly_by_rank(sums, 16), (Numbers{3, 1, 5, 4, 2, 0})) << "all there are";
    EXPECT_EQ(evenly_by_rank({7, 7, 7}, 3), (Numbers{0, 1, 2})) << "equal ones in their order";
    std::vector<double> fifty;
    for (int n = 0; n < 50; ++n) fifty.push_back(n);
    const Numbers nine = evenly_by_rank(fifty, 9);
    for (std::size_t n = 0; n < 9; ++n) EXPECT_NEAR(static_cast<double>(nine[n]), 49.0 * static_cast<double>(n) / 8, 0.5);
}

}  // namespace
}  // namespace tedavis::host_sim::test_ensemble
