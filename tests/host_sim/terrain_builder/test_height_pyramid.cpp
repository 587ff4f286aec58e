#include "host_sim/terrain_builder/height_pyramid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_height_pyramid {
namespace {

using terrain::PostClass;

struct Built {
    test_support::TemporaryFolder folder;
    PostsFile posts;
    HeightPyramid pyramid;

    /// Heights that are NaN are void.
    template <class Height>
    Built(std::uint32_t columns, std::uint32_t rows, bool closed, Height height)
        : posts(folder.file("posts"), columns, rows, closed), pyramid(folder.path(), posts, closed) {
        for (std::uint32_t j = 0; j < rows; ++j)
            for (std::uint32_t i = 0; i < columns; ++i) {
                const float h = height(closed && i == columns - 1 ? 0 : i, j);
                const bool is_void = std::isnan(h);
                const float stored = is_void ? 0 : h;
                const PostClass post_class = is_void ? PostClass::void_ : h == 0 ? PostClass::sea : PostClass::land;
                posts.write(i, j, 1, 1, {&stored, 1}, {&post_class, 1});
            }
        for (std::uint32_t m = 1; m < pyramid.level_count(); ++m)
            for (std::uint32_t b = pyramid.block_count(m); b-- > 0;) pyramid.build_block(m, b);
    }
    void fill() {
        for (std::uint32_t m = pyramid.level_count(); m-- > 0;)
            for (std::uint32_t b = pyramid.block_count(m); b-- > 0;) pyramid.fill_block(m, b);
    }
    LatticeWindow all(std::uint32_t m) {
        LatticeWindow w;
        w.columns = pyramid.level(m).columns();
        w.rows = pyramid.level(m).rows();
        pyramid.level(m).read(w);
        return w;
    }
};

TEST(HeightPyramid, HalvesDownToTwoByTwo) {
    Built built(1100, 33, false, [](auto, auto) { return 7.0f; });
    EXPECT_EQ(built.pyramid.level(1).columns(), 551u) << "1099 cells, 550 pairs";
    EXPECT_EQ(built.pyramid.level(1).rows(), 17u);
    const std::uint32_t top = built.pyramid.level_count() - 1;
    EXPECT_EQ(built.pyramid.level(top).columns(), 2u);
    EXPECT_EQ(built.pyramid.level(top).rows(), 2u);
    for (std::uint32_t m = 1; m <= top; ++m)
        for (const float h : built.all(m).height_m) ASSERT_EQ(h, 7);
}

TEST(HeightPyramid, APlaneStaysAPlaneAtTheSamePlaces) {
    Built built(129, 97, false, [](auto i, auto j) { return 2.0f * i + 3.0f * j + 5; });
    for (std::uint32_t m = 1; m < 4; ++m) {
        const LatticeWindow w = built.all(m);
        for (std::uint32_t j = 1; j + 1 < w.rows; ++j)
            for (std::uint32_t i = 1; i + 1 < w.columns; ++i)
                ASSERT_NEAR(w.height_m[w.at(i, j)], (2.0f * i + 3.0f * j) * (1 << m) + 5, 1e-3) << m;
    }
}

TEST(HeightPyramid, OnlyKnownPostsCountAndVoidsNeedTheMajority) {
    Built built(65, 65, false, [](auto i, auto j) { return i > 20 && i < 40 && j > 20 && j < 40 ? std::nanf("") : 100.0f; });
    const LatticeWindow w = built.all(1);
    EXPECT_TRUE(std::isnan(w.height_m[w.at(15, 15)]));
    EXPECT_EQ(w.post_class[w.at(15, 15)], PostClass::void_);
    EXPECT_EQ(w.height_m[w.at(20, 15)], 100) << "post 40 is known, 39 is not";
    EXPECT_EQ(w.post_class[w.at(20, 15)], PostClass::land);
    EXPECT_EQ(w.post_class[w.at(19, 15)], PostClass::void_) << "38 and 37 are not known";
    const LatticeWindow sea = Built(33, 33, false, [](auto i, auto) { return i < 10 ? 0.0f : 4.0f; }).all(1);
    EXPECT_EQ(sea.post_class[sea.at(2, 3)], PostClass::sea);
    EXPECT_EQ(sea.post_class[sea.at(7, 3)], PostClass::land);
}

TEST(HeightPyramid, ClosesRoundTheEarthAtEveryLevel) {
    Built built(361, 90, true, [](auto i, auto) { return 100 * std::cos(6.2831853f * static_cast<float>(i) / 360); });
    for (std::uint32_t m = 1; m < built.pyramid.level_count(); ++m) {
        const LatticeWindow w = built.all(m);
        for (std::uint32_t j = 0; j < w.rows; ++j) ASSERT_EQ(w.height_m[w.at(w.columns - 1, j)], w.height_m[w.at(0, j)]) << m;
    }
    const LatticeWindow w = built.all(1);
    EXPECT_NEAR(w.height_m[w.at(0, 5)], 100 * (2 + 2 * std::cos(6.2831853 / 360)) / 4, 1e-3)
        << "its western neighbour is beyond the seam";
}

TEST(HeightPyramid, VoidsAreFilledBetweenWhatIsKnown) {
    const auto height = [](std::uint32_t i, std::uint32_t j) {
        const bool hole = i > 30 && i < 50 && j > 20 && j < 44;
        return hole ? std::nanf("") : 2.0f * static_cast<float>(i) + 500;
    };
    Built built(129, 97, false, height);
    built.fill();
    const LatticeWindow w = built.all(0);
    for (std::int64_t j = 0; j < 97; ++j)
        for (std::int64_t i = 0; i < 129; ++i) {
            const std::size_t n = w.at(i, j);
            if (w.post_class[n] != PostClass::void_) {
                ASSERT_EQ(w.height_m[n], 2.0f * static_cast<float>(i) + 500);
            } else {
                ASSERT_NEAR(w.height_m[n], 2.0f * static_cast<float>(i) + 500, 15) << i << " " << j;
            }
        }
    EXPECT_EQ(w.post_class[w.at(40, 30)], PostClass::void_) << "a filled post stays unknown";
    built.fill();
    EXPECT_EQ(built.all(0).height_m, w.height_m) << "filling again changes nothing";
}

TEST(HeightPyramid, BlocksInAnyOrderGiveTheSame) {
    const auto height = [](std::uint32_t i, std::uint32_t j) {
        return (i * 31 + j * 17) % 23 == 0 ? std::nanf("") : 1.0f * (i % 19) * j;
    };
    Built forward(1300, 700, false, height), again(1300, 700, false, height);
    ASSERT_GT(forward.pyramid.block_count(1), 1u);
    for (std::uint32_t b = 0; b < again.pyramid.block_count(1); ++b) again.pyramid.build_block(1, b);
    for (std::uint32_t m = 1; m < 3; ++m) EXPECT_EQ(forward.all(m).post_class, again.all(m).post_class);
    forward.fill();
    for (std::uint32_t m = again.pyramid.level_count(); m-- > 0;)
        for (std::uint32_t b = 0; b < again.pyramid.block_count(m); ++b) again.pyramid.fill_block(m, b);
    EXPECT_EQ(forward.all(0).height_m, again.all(0).height_m);
}

}  // namespace
}  // namespace tedavis::host_sim::test_height_pyramid
