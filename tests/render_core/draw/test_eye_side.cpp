#include "render_core/draw/eye_side.hpp"

#include <gtest/gtest.h>

namespace tedavis::draw::test_eye_side {
namespace {

TEST(EyeSide, ShiftsStayWithinTheMargin) {
    constexpr std::uint32_t kMargin = 5;
    EXPECT_EQ(screen_begins_px(kMargin, EyeSide::left, 2), 7);
    EXPECT_EQ(screen_begins_px(kMargin, EyeSide::right, 2), 3);
    EXPECT_EQ(screen_begins_px(kMargin, EyeSide::left, 100), 10);
    EXPECT_EQ(screen_begins_px(kMargin, EyeSide::right, 100), 0);
}

}  // namespace
}  // namespace tedavis::draw::test_eye_side
