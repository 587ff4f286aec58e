#include "host_sim/measure/lab_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_lab_picture {
namespace {

RgbaPicture grey_ramp() {
    // Of equal steps of L*, by the inverse of its definition: 20 .. 80.
    RgbaPicture made{31, 5, {}};
    for (std::uint32_t n = 0; n < 31 * 5; ++n) {
        const double light = std::pow((20 + 2.0 * (n % 31) + 16) / 116, 3);
        const auto level = static_cast<std::uint8_t>(std::lround(255 * (1.055 * std::pow(light, 1 / 2.4) - 0.055)));
        for (const std::uint8_t byte : {level, level, level, std::uint8_t{255}}) made.pixels.push_back(byte);
    }
    return made;
}

TEST(LabPicture, AnEvenRampIsAsSteepAsItIs) {
    const RgbaPicture ramp = grey_ramp();
    const LabPicture lab(view_of(ramp));
    for (std::uint32_t x = 1; x < 30; ++x) EXPECT_NEAR(lab.gradient(x, 2), 2, 0.15) << x;
    EXPECT_NEAR(lab.gradient(0, 2), 1, 0.15) << "beyond the border it goes on level";
    EXPECT_NEAR(lab.at(10, 2).lightness, 40, 0.2);
}

}  // namespace
}  // namespace tedavis::host_sim::test_lab_picture
