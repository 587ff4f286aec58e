#include "host_sim/accuracy/knobs/measured_picture.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace tedavis::host_sim::test_measured_picture {
namespace {

TEST(MeasuredPicture, AreTheSameOnEveryRun) {
    SeededRandom numbers(1), same(1), others(2);
    const MeasuredPicture picture(numbers), again(same), other(others);
    const std::size_t bytes = 3u * MeasuredPicture::kWidth * MeasuredPicture::kHeight;
    ASSERT_TRUE(picture.view().is_valid());
    EXPECT_EQ(std::memcmp(picture.view().pixels, again.view().pixels, bytes), 0);
    EXPECT_NE(std::memcmp(picture.view().pixels, other.view().pixels, bytes), 0) << "control: other numbers";
    const std::set<std::uint8_t> levels(picture.view().pixels, picture.view().pixels + bytes);
    EXPECT_GT(levels.size(), 100u) << "the picture has smooth ground";
}

TEST(MeasuredPicture, AShrunkPictureHasMeans) {
    SeededRandom numbers(3);
    const MeasuredPicture picture(numbers), half = picture.shrunk(2);
    EXPECT_EQ(half.view().width, MeasuredPicture::kWidth / 2);
    EXPECT_EQ(half.view().height, MeasuredPicture::kHeight / 2);
    for (const int x : {0, 100, 319})
        for (const int color : {0, 1, 2}) {
            const auto at = [&](int column, int row) { return int{picture.view().row(row)[3 * column + color]}; };
            const int sum = at(2 * x, 20) + at(2 * x + 1, 20) + at(2 * x, 21) + at(2 * x + 1, 21);
            EXPECT_EQ(int{half.view().row(10)[3 * x + color]}, (sum + 2) / 4);
        }
}

}  // namespace
}  // namespace tedavis::host_sim::test_measured_picture
