#include "host_sim/measure/sign_contrast.hpp"

#include <gtest/gtest.h>

#include "render_core/design/color.hpp"
#include "render_core/perception/contrast_ratio.hpp"

namespace tedavis::host_sim::test_sign_contrast {
namespace {

using design::Color;

constexpr std::uint8_t kGround = 0, kSigns = 1, kFront = 2;

/// A picture of one colour, into which signs are painted.
class Painting {
public:
    explicit Painting(Color ground, std::uint32_t width = 80, std::uint32_t height = 60)
        : picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height * 4, 255)},
          mask{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, kGround), {"ground", "signs", "front"}} {
        fill(0, 0, static_cast<int>(width), static_cast<int>(height), ground, kGround);
    }
    Painting& fill(int left, int top, int right, int bottom, Color color, std::uint8_t layer) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x);
                picture.pixels[4 * at] = color.red;
                picture.pixels[4 * at + 1] = color.green;
                picture.pixels[4 * at + 2] = color.blue;
                mask.layers[at] = layer;
            }
        return *this;
    }
    /// A stroke of 20 x 4 pixels, with a rim of so many round it.
    Painting& sign(Color color, Color rim = {}, int rim_px = 0) {
        if (rim_px > 0) fill(30 - rim_px, 28 - rim_px, 50 + rim_px, 32 + rim_px, rim, kSigns);
        return fill(30, 28, 50, 32, color, kSigns);
    }
    [[nodiscard]] std::vector<SignContrast> signs(std::uint32_t least_px = 24) const {
        return sign_contrasts(picture, mask, kSigns, least_px);
    }
    [[nodiscard]] double ratio() const {
        const auto all = signs();
        EXPECT_EQ(all.size(), 1u);
        return all.empty() ? 0 : all[0].ratio;
    }
    RgbaPicture picture;
    LayerMask mask;
};

double ratio_of(Color a, Color b) {
    return perception::contrast_ratio(design::relative_luminance(a), design::relative_luminance(b));
}

constexpr Color kWhite{255, 255, 255}, kBlack{0, 0, 0}, kLight{220, 220, 210}, kGrey{120, 120, 120};

TEST(SignContrast, APlainSignIsComparedWithItsGround) {
    EXPECT_NEAR(Painting(kBlack).sign(kWhite).ratio(), 21, 1e-9);
    EXPECT_NEAR(Painting(kGrey).sign(kWhite).ratio(), ratio_of(kGrey, kWhite), 1e-9);
    EXPECT_NEAR(Painting(kWhite).sign(kGrey).ratio(), ratio_of(kGrey, kWhite), 1e-9) << "either way";
    const Color grey_again{130, 130, 130};
    EXPECT_LT(Painting(kGrey).sign(grey_again).ratio(), 1.3) << "grey on grey is not seen";
}

TEST(SignContrast, ALightSignOnLightGroundFailsAndADarkRimSavesItOnAnyGround) {
    EXPECT_LT(Painting(kLight).sign(kWhite).ratio(), 3);
    for (const Color ground : {kWhite, kLight, kGrey, kBlack, Color{90, 120, 60}})
        EXPECT_GT(Painting(ground).sign(kWhite, kBlack, 1).ratio(), 15) << int{ground.red};
}

TEST(SignContrast, APlainSignMustDifferFromAllThatBordersOnIt) {
    Painting half(kBlack);
    half.fill(40, 0, 80, 60, kLight, kGround);
    EXPECT_LT(half.sign(kWhite).ratio(), 3) << "one half of it is lost";
    half.sign(kWhite, kBlack, 1);
    EXPECT_GT(half.ratio(), 15);
    Painting touched(kBlack);
    touched.fill(49, 0, 51, 28, kLight, kGround);
    EXPECT_GT(touched.sign(kWhite).ratio(), 15) << "a tenth of the border may be alike";
}

TEST(SignContrast, AStrokeOnALargePanelCounts) {
    const Color panel{30, 40, 60};
    Painting large(panel, 400, 300);
    large.fill(10, 10, 390, 290, panel, kSigns);
    EXPECT_LT(large.ratio(), 1.01) << "an empty panel of the ground's colour";
    large.fill(100, 100, 120, 104, kWhite, kSigns);
    EXPECT_NEAR(large.ratio(), ratio_of(panel, kWhite), 1e-9);
}

TEST(SignContrast, SignsAreConnectedPatchesInTheOrderOfTheirFirstPixels) {
    Painting several(kBlack);
    several.fill(50, 5, 60, 10, kWhite, kSigns).fill(5, 20, 15, 25, kGrey, kSigns).fill(15, 25, 25, 30, kGrey, kSigns);
    several.fill(70, 50, 73, 53, kWhite, kSigns);
    const auto signs = several.signs();
    ASSERT_EQ(signs.size(), 2u) << "patches that meet in a corner are one, and nine pixels are none";
    EXPECT_EQ(signs[0].box.left, 50);
    EXPECT_EQ(signs[0].pixels, 50u);
    EXPECT_EQ(signs[1].box.right, 25);
    EXPECT_EQ(signs[1].box.bottom, 30);
    EXPECT_EQ(several.signs(9).size(), 3u);
    EXPECT_TRUE(sign_contrasts(several.picture, several.mask, kFront, 1).empty());
}

TEST(SignContrast, WhatIsCoveredIsNoSign) {
    Painting covered(kLight);
    covered.fill(20, 20, 60, 40, kBlack, kFront).sign(kBlack);
    EXPECT_TRUE(covered.signs().empty()) << "a black sign of which a black panel in front leaves nothing to see";
    Painting beside(kLight);
    beside.sign(kWhite).fill(0, 0, 30, 60, kBlack, kFront);
    EXPECT_EQ(beside.signs().size(), 1u) << "a panel beside it covers nothing";
}

TEST(SignContrast, TheEdgeOfACoveredSignIsNoSign) {
    Painting strip(kLight);
    strip.sign(kWhite).fill(0, 0, 49, 60, kBlack, kFront);
    EXPECT_TRUE(strip.signs(2).empty()) << "one column of it is left beside the bar";
    Painting thin(kLight);
    thin.sign(kWhite).fill(0, 0, 49, 60, kLight, 0);
    EXPECT_EQ(thin.signs(2).size(), 1u) << "the control: as thin, and nothing in front";
}

}  // namespace
}  // namespace tedavis::host_sim::test_sign_contrast
