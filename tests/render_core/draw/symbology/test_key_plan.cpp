#include "render_core/draw/symbology/key_plan.hpp"

#include <gtest/gtest.h>

namespace tedavis::draw::test_key_plan {
namespace {

constexpr Rect kRoom{100, 50, 400, 300};
constexpr float kLarge_px2 = 1e7f;

TEST(KeyPlan, TheTextOfACellCanBeReadOnEveryScreen) {
    EXPECT_EQ(key_cell(8).em_px, 11) << "a screen of 320 x 240";
    EXPECT_NEAR(key_cell(24).em_px, 16.8f, 1e-4f);
    for (const float text_px : {4.0f, 8.0f, 24.0f, 80.0f}) {
        const KeyCell cell = key_cell(text_px);
        EXPECT_NEAR(cell.width_px / cell.em_px, key_cell(1).width_px / 11, 1e-4f) << "the cell grows with its text";
        EXPECT_GT(cell.height_px, 2 * cell.em_px) << "two rows";
    }
}

TEST(KeyPlan, AColumnStandsAtTheFootOfItsRoom) {
    const KeyPlan plan = plan_key(kRoom, KeyOrder::column, 3, kLarge_px2, 16);
    ASSERT_EQ(plan.shown, 3u);
    EXPECT_EQ(plan.cut, 0u);
    EXPECT_NEAR(plan.box.bottom(), kRoom.bottom(), 1e-3f);
    EXPECT_EQ(plan.box.x, kRoom.x);
    EXPECT_EQ(plan.cell_at(0).y, plan.box.y);
    EXPECT_NEAR(plan.cell_at(2).bottom(), kRoom.bottom(), 1e-3f);
    for (std::size_t n = 0; n + 1 < plan.shown; ++n) EXPECT_FALSE(plan.cell_at(n).overlaps(plan.cell_at(n + 1)));
}

TEST(KeyPlan, RowsStandAtTheUpperLeftCorner) {
    const KeyPlan plan = plan_key(kRoom, KeyOrder::rows, 5, kLarge_px2, 16);
    ASSERT_EQ(plan.shown, 5u);
    EXPECT_EQ(plan.across, 3u) << "as many as the room is wide";
    EXPECT_EQ(plan.box.x, kRoom.x);
    EXPECT_EQ(plan.box.y, kRoom.y);
    EXPECT_EQ(plan.cell_at(2).y, kRoom.y);
    EXPECT_EQ(plan.cell_at(3).x, kRoom.x);
    EXPECT_GT(plan.cell_at(3).y, plan.cell_at(0).bottom());
    for (std::size_t n = 0; n < plan.shown; ++n) {
        EXPECT_TRUE(plan.box.shrunk(-0.01f).contains(plan.cell_at(n))) << n;
        for (std::size_t k = 0; k < n; ++k) EXPECT_FALSE(plan.cell_at(n).overlaps(plan.cell_at(k)));
    }
    const KeyPlan low = plan_key({100, 50, 400, 40}, KeyOrder::rows, 5, kLarge_px2, 16);
    EXPECT_EQ(low.shown, 3u) << "room for one row";
    EXPECT_EQ(low.cut, 2u);
}

TEST(KeyPlan, ATwentiethOfThePictureIsTheMost) {
    const KeyCell cell = key_cell(16);
    const float two = cell.width_px * (2 * cell.height_px + cell.gap_px) / kMaxKeyShare;
    EXPECT_EQ(plan_key(kRoom, KeyOrder::column, 4, 1.001f * two, 16).shown, 2u);
    EXPECT_EQ(plan_key(kRoom, KeyOrder::column, 4, 0.999f * two, 16).shown, 1u) << "a picture that is a little smaller";
    const KeyPlan none = plan_key(kRoom, KeyOrder::column, 4, 0.4f * two, 16);
    EXPECT_EQ(none.shown, 0u);
    EXPECT_EQ(none.cut, 4u);
    EXPECT_TRUE(none.box.empty());
}

TEST(KeyPlan, NothingStandsInRoomThatIsTooNarrow) {
    const KeyCell cell = key_cell(16);
    EXPECT_EQ(plan_key({0, 0, 0.99f * cell.width_px, 500}, KeyOrder::column, 2, kLarge_px2, 16).shown, 0u);
    EXPECT_EQ(plan_key({0, 0, 1.01f * cell.width_px, 500}, KeyOrder::column, 2, kLarge_px2, 16).shown, 2u);
    EXPECT_EQ(plan_key({0, 0, 500, 0.99f * cell.height_px}, KeyOrder::rows, 2, kLarge_px2, 16).shown, 0u);
    EXPECT_EQ(plan_key({0, 0, -20, -20}, KeyOrder::rows, 2, kLarge_px2, 16).shown, 0u);
    EXPECT_EQ(plan_key(kRoom, KeyOrder::column, 0, kLarge_px2, 16).shown, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_key_plan
