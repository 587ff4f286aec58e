#include "render_core/perception/contrast_ratio.hpp"

#include <gtest/gtest.h>

#include "render_core/design/color.hpp"

namespace tedavis::perception::test_contrast_ratio {
namespace {

double ratio(const design::Color& one, const design::Color& other) {
    return contrast_ratio(design::relative_luminance(one), design::relative_luminance(other));
}

// Examples of WCAG's own techniques and of its understanding documents.
TEST(ContrastRatio, IsWcags) {
    EXPECT_NEAR(ratio({0, 0, 0}, {255, 255, 255}), 21, 1e-9);
    EXPECT_DOUBLE_EQ(ratio({90, 12, 200}, {90, 12, 200}), 1);
    EXPECT_NEAR(ratio({0x77, 0x77, 0x77}, {255, 255, 255}), 4.48, 0.005);
    EXPECT_NEAR(ratio({0x76, 0x76, 0x76}, {255, 255, 255}), 4.54, 0.005);
    EXPECT_NEAR(ratio({255, 255, 255}, {0x94, 0x94, 0x94}), 3.03, 0.005);
}

TEST(ContrastRatio, HasNoOrder) { EXPECT_DOUBLE_EQ(contrast_ratio(0.2, 0.7), contrast_ratio(0.7, 0.2)); }

}  // namespace
}  // namespace tedavis::perception::test_contrast_ratio
