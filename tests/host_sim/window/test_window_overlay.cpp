// What the window adds: it says what it is, lies where the display's own frame can be told from it, and fits.
#include "host_sim/window/window_overlay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "host_sim/window/window_keys.hpp"

namespace tedavis::host_sim::test_window_overlay {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

HeadUp example() {
    HeadUp head_up;
    head_up.flight_s = 12.5;
    head_up.last_s = 417;
    head_up.speed = 0.5;
    head_up.phase = "cruise (switch)";
    head_up.design = "default";
    return head_up;
}

TEST(WindowOverlay, TheLineSaysWhatIsPlayed) {
    HeadUp head_up = example();
    EXPECT_EQ(head_up_text(head_up), "WINDOW\n12.50 / 417.00 s  x0.5\nphase cruise (switch)  design default");
    head_up.is_playing = false;
    head_up.is_backwards = true;
    head_up.camera = "tour";
    EXPECT_THAT(head_up_text(head_up), HasSubstr("x0.5 backwards  PAUSED\nphase"));
    EXPECT_THAT(head_up_text(head_up), HasSubstr("default  tour"));
}

TEST(WindowOverlay, TheDateIsSaidWhereItIsKnown) {
    HeadUp head_up = example();
    head_up.time = {base::Time{1'700'000'000'000'000'000}, false, false};
    EXPECT_THAT(head_up_text(head_up), Not(HasSubstr("2023")));
    head_up.time.is_date = true;
    EXPECT_THAT(head_up_text(head_up), HasSubstr("2023-11-14T22:13:20"));
    EXPECT_THAT(head_up_text(head_up), HasSubstr("not confirmed"));
    head_up.time.is_confirmed = true;
    EXPECT_THAT(head_up_text(head_up), Not(HasSubstr("not confirmed")));
}

bool lies_inside(const std::vector<PaintedRect>& rects, std::uint32_t width, std::uint32_t height) {
    return std::all_of(rects.begin(), rects.end(), [&](const PaintedRect& rect) {
        return rect.left + rect.width <= width && rect.top + rect.height <= height && rect.width > 0 && rect.height > 0;
    });
}

TEST(WindowOverlay, FitsEveryPicture) {
    const WindowOverlay overlay{head_up_text(example()), window_keys_lines()};
    for (const auto& [width, height] : {std::pair{1600u, 1000u}, {640u, 480u}, {160u, 120u}, {40u, 30u}, {16u, 16u}})
        EXPECT_TRUE(lies_inside(overlay_rects(overlay, width, height), width, height)) << width << " x " << height;
    EXPECT_TRUE(overlay_rects({}, 640, 480).empty());
}

TEST(WindowOverlay, TheLinesLieInTheLowerLeftCornerInTwoColors) {
    const std::vector<PaintedRect> rects = overlay_rects({head_up_text(example()), {}}, 800, 600);
    ASSERT_GT(rects.size(), 50u);
    std::set<std::array<std::uint8_t, 3>> colors;
    for (const PaintedRect& rect : rects) {
        EXPECT_GT(rect.top, 550u);
        EXPECT_LT(rect.left + rect.width, 250u) << "notices stand in the middle";
        colors.insert(rect.color);
    }
    EXPECT_EQ(colors.size(), 2u);
    const std::vector<PaintedRect> other = overlay_rects({head_up_text(example()) + ".", {}}, 800, 600);
    EXPECT_NE(other.size(), rects.size()) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_window_overlay
