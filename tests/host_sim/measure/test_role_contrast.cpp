#include "host_sim/measure/role_contrast.hpp"

#include <gtest/gtest.h>

#include "render_core/design/color.hpp"

namespace tedavis::host_sim::test_role_contrast {
namespace {

using design::Color;
using design::SymbolRole;

constexpr std::uint8_t kGround = 0, kSigns = 1;
constexpr Color kSky{120, 170, 230}, kBlack{0, 0, 0};

/// A picture of one color, into which signs are painted.
class Painting {
public:
    explicit Painting(Color ground)
        : picture{80, 60, std::vector<std::uint8_t>(std::size_t{80} * 60 * 4, 255)},
          mask{80, 60, std::vector<std::uint8_t>(std::size_t{80} * 60, kGround), {"ground", "symbology"}} {
        fill(0, 0, 80, 60, ground, kGround);
    }
    Painting& fill(int left, int top, int right, int bottom, Color color, std::uint8_t layer = kSigns) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * 80 + static_cast<std::size_t>(x);
                picture.pixels[4 * at] = color.red;
                picture.pixels[4 * at + 1] = color.green;
                picture.pixels[4 * at + 2] = color.blue;
                mask.layers[at] = layer;
            }
        return *this;
    }
    [[nodiscard]] std::vector<RoleContrast> signs(std::uint32_t least_px = 12) const {
        return role_contrasts(picture, mask, kSigns, design::kDaySymbology, least_px);
    }
    RgbaPicture picture;
    LayerMask mask;
};

Color of(SymbolRole role) { return design::kDaySymbology.color(role); }

/// WCAG 2.1's ratio, written down once more.
double ratio_of(Color a, Color b) {
    const double first = relative_luminance(a), second = relative_luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

TEST(RoleContrast, ASignWithARimIsComparedWithTheRimAndOneWithoutWithTheGround) {
    const auto rimmed = Painting(kSky).fill(28, 26, 52, 34, kBlack).fill(30, 28, 50, 32, of(SymbolRole::warning)).signs();
    ASSERT_EQ(rimmed.size(), 1u);
    EXPECT_EQ(rimmed[0].role, SymbolRole::warning);
    EXPECT_EQ(rimmed[0].pixels, 80u);
    EXPECT_EQ(rimmed[0].box.left, 30);
    EXPECT_EQ(rimmed[0].box.bottom, 32);
    EXPECT_NEAR(rimmed[0].ratio, ratio_of(of(SymbolRole::warning), kBlack), 1e-9);
    const auto bare = Painting(kSky).fill(30, 28, 50, 32, of(SymbolRole::warning)).signs();
    ASSERT_EQ(bare.size(), 1u);
    EXPECT_NEAR(bare[0].ratio, ratio_of(of(SymbolRole::warning), kSky), 1e-9);
    EXPECT_LT(bare[0].ratio, 2) << "the control: red does not stand out from the sky";
}

TEST(RoleContrast, AHalfRimIsNotEnough) {
    // Above and to the left only, too thin to reach around.
    const auto half = Painting(kSky).fill(28, 24, 60, 30, kBlack).fill(30, 30, 50, 40, of(SymbolRole::warning)).signs();
    ASSERT_EQ(half.size(), 1u);
    EXPECT_LT(half[0].ratio, 4.5);
}

TEST(RoleContrast, EachRoleHasItsOwnSigns) {
    const auto signs = Painting(kBlack)
                           .fill(10, 10, 20, 14, of(SymbolRole::caution))
                           .fill(30, 10, 40, 14, of(SymbolRole::scale))
                           .fill(50, 10, 60, 14, of(SymbolRole::caution))
                           .signs();
    ASSERT_EQ(signs.size(), 3u);
    EXPECT_EQ(signs[0].role, SymbolRole::scale);
    EXPECT_EQ(signs[1].role, SymbolRole::caution);
    EXPECT_EQ(signs[2].box.left, 50);
    EXPECT_NEAR(signs[0].ratio, 21, 1e-9);
}

TEST(RoleContrast, WhatIsSmallOrOfAnotherLayerOrBlendedIsNoSign) {
    EXPECT_TRUE(Painting(kBlack).fill(10, 10, 13, 13, of(SymbolRole::scale)).signs().empty());
    EXPECT_EQ(Painting(kBlack).fill(10, 10, 13, 13, of(SymbolRole::scale)).signs(9).size(), 1u);
    EXPECT_TRUE(Painting(kBlack).fill(10, 10, 30, 20, of(SymbolRole::scale), kGround).signs().empty());
    EXPECT_TRUE(Painting(kBlack).fill(10, 10, 30, 20, {180, 180, 180}).signs().empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_role_contrast
