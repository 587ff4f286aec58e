#include "render_core/draw/data/label_room.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tedavis::draw::test_label_room {
namespace {

/// Against a look at every box, within the screen and beyond it.
TEST(LabelRoom, FindsTheFirstBoxThatIsInTheWay) {
    std::uint32_t state = 7;
    const auto next = [&](float most) {
        state = state * 1664525u + 1013904223u;
        return most * static_cast<float>(state >> 8) / static_cast<float>(1u << 24);
    };
    std::size_t hits = 0, clear = 0;
    for (int turn = 0; turn < 20; ++turn) {
        LabelRoom room({0, 0, 640, 480});
        std::vector<Rect> boxes;
        for (std::size_t n = 0; n < LabelRoom::kMost; ++n) {
            Rect box{next(700) - 30, next(540) - 30, next(60) + 1, next(30) + 1};
            if (n % 5 == 0) box = {};
            boxes.push_back(box);
            room.take(box);
        }
        room.take({0, 0, 640, 480});
        for (int n = 0; n < 500; ++n) {
            const Rect asked{next(700) - 30, next(540) - 30, next(20) + 1, next(10) + 1};
            std::size_t first = 0;
            while (first < boxes.size() && (boxes[first].empty() || !boxes[first].overlaps(asked))) ++first;
            const bool is_clear = first == boxes.size();
            EXPECT_EQ(room.in_the_way(asked), is_clear ? LabelRoom::kNobody : first);
            ++(is_clear ? clear : hits);
        }
    }
    EXPECT_GT(hits, 1000u);
    EXPECT_GT(clear, 1000u);
}

}  // namespace
}  // namespace tedavis::draw::test_label_room
