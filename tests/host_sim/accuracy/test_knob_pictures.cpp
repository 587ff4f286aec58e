#include "host_sim/accuracy/knob_pictures.hpp"

#include <gtest/gtest.h>

#include "host_sim/measure/picture_difference.hpp"
#include "render_core/design/color_difference.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_knob_pictures {
namespace {

constexpr std::uint32_t kWidth = 60, kHeight = 50, kDotX = 57, kDotY = 3;

/// Grey, with a red dot if asked for.
RgbaPicture picture(bool has_dot) {
    RgbaPicture made{kWidth, kHeight, {}};
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const bool is_dot = has_dot && x == kDotX && y == kDotY;
            for (const int byte : {is_dot ? 250 : 90, is_dot ? 20 : 90, is_dot ? 20 : 90, 255})
                made.pixels.push_back(static_cast<std::uint8_t>(byte));
        }
    return made;
}

KnobPictures compared(bool cheap_has_dot) {
    const RgbaPicture cheap = picture(cheap_has_dot), exact = picture(false);
    return compare_pictures("made", view_of(cheap), view_of(exact), {"a pose", "a command", kDotX, kDotY});
}

TEST(KnobPictures, StateTheDifferenceThatOtherMeasuresState) {
    const RgbaPicture cheap = picture(true), exact = picture(false);
    const PictureDifference expected = picture_difference(view_of(cheap), view_of(exact));
    const KnobPictures pictures = compared(true);
    EXPECT_DOUBLE_EQ(pictures.errors.color_max, expected.largest);
    EXPECT_NEAR(pictures.errors.color_mean, expected.mean, 1e-12);
    EXPECT_GT(pictures.errors.perceived_max, 0.1);
    EXPECT_EQ(compared(false).errors.color_max, 0) << "control";
    EXPECT_EQ(compared(false).errors.perceived_max, 0) << "control";
    EXPECT_EQ(pictures.cheap.file, "made-cheap.png");
    EXPECT_EQ(pictures.cheap.png, encode_small_png(view_of(cheap)));
}

TEST(KnobPictures, RefuseOtherSizes) {
    const RgbaPicture cheap = picture(true), none{0, 0, {}};
    test_support::expect_user_error([&] { static_cast<void>(compare_pictures("made", view_of(cheap), view_of(none), {})); },
                                    "different sizes");
}

TEST(ErrorMap, RisesInLightnessWithTheError) {
    const RgbaPicture map = error_map({0, 0.25, 0.5, 0.75, 1, 7}, 3, 1);
    EXPECT_EQ(map.width, 3u);
    EXPECT_EQ(map.height, 2u);
    const auto lightness = [&](std::size_t n) {
        const std::uint8_t* const p = &map.pixels[4 * n];
        return design::lab_of(design::linear_rgb({p[0], p[1], p[2]})).lightness;
    };
    for (std::size_t n = 1; n < 5; ++n) EXPECT_GT(lightness(n), lightness(n - 1) + 10) << n;
    EXPECT_EQ(lightness(5), lightness(4)) << "beyond the scale";
}

TEST(MetricMap, PaintsEachErrorRoundItsPixelAndTheRestGrey) {
    const RgbaPicture map = metric_map({0, 2, 1}, {{5, 5}, {15, 5}, {25, 5}}, {40, 20});
    const auto color = [&](std::uint32_t x, std::uint32_t y) { return &map.pixels[(std::size_t{y} * 40 + x) * 4]; };
    const RgbaPicture ramp = error_map({0, 2, 1}, 3, 2);
    for (std::uint32_t n = 0; n < 3; ++n)
        EXPECT_TRUE(std::equal(color(5 + 10 * n, 5), color(5 + 10 * n, 5) + 4, &ramp.pixels[4 * n])) << n;
    EXPECT_EQ(*color(38, 18), 128) << "no error is known there";
    EXPECT_EQ(metric_map({}, {}, {4, 4}).pixels.size(), 64u);
}

TEST(EnlargedCrop, StaysWithinThePictureAndHoldsThePlace) {
    const RgbaPicture whole = picture(true), crop = enlarged_crop(view_of(whole), kDotX, kDotY, 10, 2);
    EXPECT_EQ(crop.width, 20u);
    EXPECT_EQ(crop.height, 20u);
    const std::size_t left = kWidth - 10, at = (std::size_t{2 * kDotY} * crop.width + 2 * (kDotX - left)) * 4;
    EXPECT_EQ(crop.pixels[at], 250) << "the dot, near a corner";
    EXPECT_EQ(crop.pixels[at - 4], 90) << "control: beside it";
    EXPECT_EQ(enlarged_crop(view_of(whole), 1, 1, 200, 1).width, kWidth) << "larger than the picture";
}

}  // namespace
}  // namespace tedavis::host_sim::test_knob_pictures
