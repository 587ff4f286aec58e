#include "render_core/draw/symbology/layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tedavis::draw {
namespace {

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{320, 240},  {240, 320},   {640, 480},   {480, 640},   {800, 480},   {1024, 768},
                               {768, 1024}, {1080, 1920}, {1920, 1080}, {2560, 1080}, {1080, 2560}, {3840, 2160}};

TEST(Layout, NoBoxOverlapsAnotherOrLeavesTheScreen) {
    for (const Screen& screen : kScreens)
        for (double dpi : {60.0, 96.0, 160.0, 300.0}) {
            const Layout layout = make_layout(screen.width, screen.height, dpi);
            for (std::size_t i = 0; i < kLayoutBoxCount; ++i) {
                const Rect& box = layout.*kLayoutBoxes[i].box;
                EXPECT_FALSE(box.empty()) << kLayoutBoxes[i].name;
                EXPECT_TRUE(layout.screen.contains(box))
                    << kLayoutBoxes[i].name << " " << screen.width << "x" << screen.height << " " << dpi;
                for (std::size_t j = i + 1; j < kLayoutBoxCount; ++j)
                    EXPECT_FALSE(box.overlaps(layout.*kLayoutBoxes[j].box))
                        << kLayoutBoxes[i].name << " and " << kLayoutBoxes[j].name << " " << screen.width << "x" << screen.height
                        << " " << dpi;
            }
        }
}

TEST(Layout, TheViewsMiddleLiesInsideTheAttitudeWithRoomForThePitch) {
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        const Point center = layout.screen.center();
        EXPECT_TRUE(layout.attitude.shrunk(6 * layout.text_px).contains(center));
        EXPECT_NEAR(layout.heading.center().x, center.x, 0.01);
        EXPECT_GE(layout.heading.width, 12 * layout.text_px);
    }
}

TEST(Layout, TheLegendHasTheRoomThatItCountsOn) {
    for (const Screen& screen : kScreens)
        for (double dpi : {60.0, 96.0, 160.0, 300.0}) {
            const Layout layout = make_layout(screen.width, screen.height, dpi);
            EXPECT_GE(layout.legend.width, 4.99f * layout.text_px);
            EXPECT_GE(layout.legend.height, 19 * layout.text_px) << screen.width << "x" << screen.height << " " << dpi;
        }
}

TEST(Layout, TextGrowsWithTheScreenAndWithTheDensityOfThePanel) {
    EXPECT_NEAR(make_layout(1920, 1440, 96).text_px / make_layout(640, 480, 96).text_px, 3, 0.01);
    EXPECT_GT(make_layout(1920, 1080, 400).text_px, make_layout(1920, 1080, 96).text_px);
    for (const Screen& screen : kScreens) {
        float last = 0;
        for (double dpi : {60.0, 100.0, 200.0, 400.0}) {
            const float text = make_layout(screen.width, screen.height, dpi).text_px;
            EXPECT_GE(text, last);
            last = text;
        }
    }
}

TEST(Layout, ScalingTheScreenScalesEveryBox) {
    const Layout small = make_layout(640, 480, 96), large = make_layout(1280, 960, 192);
    for (const LayoutBox& entry : kLayoutBoxes) {
        const Rect &a = small.*entry.box, &b = large.*entry.box;
        EXPECT_NEAR(b.x, 2 * a.x, 0.01);
        EXPECT_NEAR(b.y, 2 * a.y, 0.01);
        EXPECT_NEAR(b.width, 2 * a.width, 0.01);
        EXPECT_NEAR(b.height, 2 * a.height, 0.01);
    }
}

}  // namespace
}  // namespace tedavis::draw
