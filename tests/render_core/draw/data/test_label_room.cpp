#include "render_core/draw/data/label_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tedavis::draw::test_label_room {
namespace {

/// Against a look at every box, within the screen and beyond it.
TEST(LabelRoom, IsFreeWhereNoBoxIsInTheWay) {
    std::uint32_t state = 7;
    const auto next = [&](float most) {
        state = state * 1664525u + 1013904223u;
        return most * static_cast<float>(state >> 8) / static_cast<float>(1u << 24);
    };
    std::size_t taken = 0, clear = 0;
    for (int turn = 0; turn < 20; ++turn) {
        LabelRoom room({0, 0, 640, 480});
        EXPECT_TRUE(room.is_empty());
        std::vector<Rect> boxes;
        for (std::size_t n = 0; n < LabelRoom::kMax; ++n) {
            boxes.push_back({next(700) - 30, next(540) - 30, next(60) + 1, next(30) + 1});
            room.take(boxes.back());
        }
        room.take({0, 0, 640, 480});
        for (int n = 0; n < 500; ++n) {
            const Rect asked{next(700) - 30, next(540) - 30, next(20) + 1, next(10) + 1};
            const bool is_clear = std::none_of(boxes.begin(), boxes.end(), [&](const Rect& box) { return box.overlaps(asked); });
            EXPECT_EQ(room.is_free(asked), is_clear);
            ++(is_clear ? clear : taken);
        }
    }
    EXPECT_GT(taken, 1000u);
    EXPECT_GT(clear, 1000u);
}

TEST(LabelRoom, OneBoxMayBeLeftOut) {
    LabelRoom room({0, 0, 640, 480});
    room.take({100, 100, 50, 20});
    room.take({300, 100, 50, 20});
    EXPECT_FALSE(room.is_free({90, 90, 30, 30}));
    EXPECT_TRUE(room.is_free({90, 90, 30, 30}, 0));
    EXPECT_FALSE(room.is_free({90, 90, 30, 30}, 1));
    room.take({140, 110, 50, 20});
    EXPECT_FALSE(room.is_free({170, 100, 30, 30}));
    EXPECT_TRUE(room.is_free({170, 100, 30, 30}, 0)) << "that overlaps it";
}

}  // namespace
}  // namespace tedavis::draw::test_label_room
