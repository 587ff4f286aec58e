#include "host_sim/terrain_builder/mesh_difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim::test_mesh_difference {
namespace {

using terrain::ChunkVertex;

constexpr double kCentre[3] = {4'300'000, 740'000, 4'600'000};
constexpr terrain::PostRange kPosts{100, 200, 132, 232};

/// Posts stand 30 m apart on a plane; heights are those of a made-up ground.
float ground_m(std::uint32_t i, std::uint32_t j) { return static_cast<float>(500 + 7 * i + 3 * j); }

ChunkVertex vertex(std::uint16_t i, std::uint16_t j) {
    ChunkVertex v{};
    v.i = i;
    v.j = j;
    v.x = static_cast<float>(30 * i);
    v.y = static_cast<float>(30 * j);
    v.height_m = v.z = ground_m(kPosts.i0 + i, kPosts.j0 + j);
    return v;
}

class MeshDifferenceOf : public ::testing::Test {
protected:
    [[nodiscard]] MeshDifference compare(const double* stated_centre_m = kCentre) {
        asked_.clear();
        return mesh_difference({stated_, stated_centre_m}, {expected_, kCentre}, kPosts,
                               [this](std::uint32_t i, std::uint32_t j) {
                                   asked_.emplace_back(i, j);
                                   return has_posts_ ? std::optional(ground_m(i, j)) : std::nullopt;
                               });
    }
    std::vector<ChunkVertex> expected_{vertex(0, 0), vertex(32, 0), vertex(32, 32), vertex(0, 32), vertex(5, 9)};
    std::vector<ChunkVertex> stated_ = expected_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> asked_;
    bool has_posts_ = true;
};

TEST_F(MeshDifferenceOf, NoneOfTheSameVerticesInAnyOrder) {
    EXPECT_EQ(compare().largest_m, 0);
    std::reverse(stated_.begin(), stated_.end());
    EXPECT_FALSE(compare().has_other_posts);
    EXPECT_EQ(compare().largest_m, 0);
    EXPECT_TRUE(asked_.empty());
}

TEST_F(MeshDifferenceOf, AHeightOrAPositionThatMoved) {
    stated_[4].height_m += 3;
    EXPECT_FALSE(compare().has_other_posts);
    EXPECT_DOUBLE_EQ(compare().largest_m, 3);
    stated_[1].x += 4;
    stated_[1].y -= 3;
    EXPECT_DOUBLE_EQ(compare().largest_m, 5);
}

TEST_F(MeshDifferenceOf, TheSamePlacesAboutAnotherCentreAreTheSame) {
    constexpr double kOther[3] = {kCentre[0] + 10, kCentre[1] - 20, kCentre[2] + 30};
    EXPECT_NEAR(compare(kOther).largest_m, std::sqrt(1400), 1e-9) << "the same numbers are other places there";
    for (ChunkVertex& v : stated_) {
        v.x -= 10;
        v.y += 20;
        v.z -= 30;
    }
    EXPECT_EQ(compare(kOther).largest_m, 0);
}

TEST_F(MeshDifferenceOf, VerticesOfOtherPostsAreHeldAgainstTheRastersNotAgainstEachOther) {
    stated_[4] = vertex(20, 30);
    EXPECT_TRUE(compare().has_other_posts);
    EXPECT_EQ(compare().largest_m, 0) << "its place is hundreds of metres from the one that the rasters give";
    ASSERT_EQ(asked_.size(), 1u);
    EXPECT_EQ(asked_[0], std::make_pair(120u, 230u));
    stated_[4].height_m -= 2;
    EXPECT_EQ(compare().largest_m, 2);
    has_posts_ = false;
    EXPECT_EQ(compare().largest_m, 0) << "nothing to hold it against";
}

TEST_F(MeshDifferenceOf, AVertexMoreOrLessIsAnotherMesh) {
    stated_.pop_back();
    EXPECT_TRUE(compare().has_other_posts);
    EXPECT_EQ(compare().largest_m, 0);
    std::swap(stated_, expected_);
    EXPECT_TRUE(compare().has_other_posts);
    EXPECT_EQ(compare().largest_m, 0);
}

TEST_F(MeshDifferenceOf, ValuesOfADamagedFileAreCountedNotFollowed) {
    stated_[0].height_m = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(compare().largest_m, kHighestHeight_m);
    stated_ = expected_;
    stated_[2].z = std::numeric_limits<float>::infinity();
    EXPECT_EQ(compare().largest_m, kHighestHeight_m);
    stated_ = expected_;
    stated_[3].i = 40'000;
    EXPECT_TRUE(compare().has_other_posts);
    EXPECT_TRUE(asked_.empty()) << "no post of the chunk";
    const double unknown[3] = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
    EXPECT_EQ(compare(unknown).largest_m, kHighestHeight_m);
}

TEST_F(MeshDifferenceOf, NeighboursAreAskedForTogether) {
    stated_.clear();
    for (const std::uint16_t n : {33, 1, 34, 2, 35, 3}) stated_.push_back(vertex(n, 4));
    constexpr terrain::PostRange kWide{100, 200, 164, 264};
    std::vector<std::uint32_t> asked;
    (void)mesh_difference({stated_, kCentre}, {expected_, kCentre}, kWide, [&](std::uint32_t i, std::uint32_t j) {
        asked.push_back(i);
        return std::optional(ground_m(i, j));
    });
    EXPECT_EQ(asked, (std::vector<std::uint32_t>{101, 102, 103, 133, 134, 135}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_mesh_difference
