#include "host_sim/terrain_builder/posts_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/terrain/lattice_windows.hpp"

namespace tedavis::host_sim::test_posts_file {
namespace {

using terrain::PostClass;
using test_support::window_of;

float height_of(std::int64_t i, std::int64_t j) { return static_cast<float>(100 * j + i); }

void fill(PostsFile& file) {
    for (std::uint32_t j = 0; j < file.rows(); ++j)
        for (std::uint32_t i = 0; i < file.columns(); ++i) {
            const float height = height_of(i, j);
            const PostClass post_class = (i + j) % 5 == 0 ? PostClass::sea : PostClass::land;
            file.write(i, j, 1, 1, {&height, 1}, {&post_class, 1});
        }
}

TEST(PostsFile, GivesWindowsAndSaysWhatIsOutside) {
    const test_support::TemporaryFolder folder;
    PostsFile file(folder.file("p"), 20, 10, false);
    fill(file);
    LatticeWindow w = window_of(-2, -1, 25, 13);
    file.read(w);
    for (std::int64_t j = -1; j < 12; ++j)
        for (std::int64_t i = -2; i < 23; ++i) {
            const bool inside = i >= 0 && j >= 0 && i < 20 && j < 10;
            ASSERT_EQ(w.post_class[w.at(i, j)] == PostClass::outside, !inside);
            ASSERT_EQ(w.is_valid(i, j), inside);
            ASSERT_EQ(w.height_m[w.at(i, j)], inside ? height_of(i, j) : 0);
        }
    EXPECT_FALSE(w.is_valid(-3, 0)) << "beyond the window";
}

TEST(PostsFile, GoesOnRoundTheEarth) {
    const test_support::TemporaryFolder folder;
    PostsFile file(folder.file("p"), 13, 6, true);  // column 12 is column 0 again
    fill(file);
    for (std::uint32_t j = 0; j < 6; ++j) {
        const float first = height_of(0, j);
        const PostClass post_class = j % 5 == 0 ? PostClass::sea : PostClass::land;
        file.write(12, j, 1, 1, {&first, 1}, {&post_class, 1});
    }
    LatticeWindow w = window_of(-15, 2, 45, 2);
    file.read(w);
    for (std::int64_t i = -15; i < 30; ++i) ASSERT_EQ(w.height_m[w.at(i, 3)], height_of(((i % 12) + 12) % 12, 3)) << i;
}

TEST(PostsFile, IsThereAgainWhenItIsOpenedAgain) {
    const test_support::TemporaryFolder folder;
    {
        PostsFile file(folder.file("p"), 20, 10, false);
        fill(file);
        file.sync();
    }
    const PostsFile file(folder.file("p"), 20, 10, false);
    LatticeWindow w = window_of(7, 8, 1, 1);
    file.read(w);
    EXPECT_EQ(w.height_m[0], height_of(7, 8));
}

}  // namespace
}  // namespace tedavis::host_sim::test_posts_file
