#include "platform/egl_kms/screen_mode.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::platform::test_screen_mode {
namespace {

TEST(ScreenMode, ReadsSizeAndRate) {
    ScreenModeWish wish;
    ASSERT_TRUE(parse_screen_mode("1024x768@60", wish));
    EXPECT_EQ(wish.width_px, 1024u);
    EXPECT_EQ(wish.height_px, 768u);
    EXPECT_EQ(wish.refresh_mhz, 60000u);
    ASSERT_TRUE(parse_screen_mode("1920x1080@59.94", wish));
    EXPECT_EQ(wish.refresh_mhz, 59940u);
    ASSERT_TRUE(parse_screen_mode("800x480", wish));
    EXPECT_EQ(wish.refresh_mhz, 0u);
    ASSERT_TRUE(parse_screen_mode("preferred", wish));
    EXPECT_TRUE(wish.is_preferred());
}

TEST(ScreenMode, RefusesWhatIsNoMode) {
    for (const char* text : {"",
                             "x",
                             "1024",
                             "1024x",
                             "x768",
                             "1024x768@",
                             "1024x768@0",
                             "1024x768@60Hz",
                             "1024x768@60.",
                             "1024x768@60.1234",
                             "1024x768@60.9x",
                             "0x768",
                             "1024x0",
                             "65536x1",
                             "-1x5",
                             "1024 x 768",
                             "1024x768 ",
                             "1024X768",
                             "Preferred",
                             "1024x768@1001",
                             "1024x768@1000.5",
                             "99999999999x5"}) {
        ScreenModeWish wish{7, 8, 9};
        EXPECT_FALSE(parse_screen_mode(text, wish)) << text;
        EXPECT_EQ(wish.width_px, 7u) << text << " leaves the wish as it was";
    }
}

TEST(ScreenMode, ItsTextIsReadBackAsTheSame) {
    for (const std::uint32_t refresh : {0u, 1000u, 23976u, 50000u, 59940u, 60000u, 60002u, 75020u, 100000u, 1000000u}) {
        const ModeText text = mode_text(1366, 768, refresh);
        ScreenModeWish wish;
        ASSERT_TRUE(parse_screen_mode(text.view(), wish)) << text.c_str();
        EXPECT_EQ(wish.width_px, 1366u);
        EXPECT_EQ(wish.height_px, 768u);
        EXPECT_EQ(wish.refresh_mhz, refresh) << text.c_str();
    }
    EXPECT_EQ(mode_text(1024, 768, 60000).view(), "1024x768@60");
    EXPECT_EQ(mode_text(1920, 1080, 59940).view(), "1920x1080@59.94");
    EXPECT_EQ(mode_text(640, 480, 100000).view(), "640x480@100");
    EXPECT_EQ(mode_text(640, 480, 0).view(), "640x480");
}

}  // namespace
}  // namespace tedavis::platform::test_screen_mode
