#include "render_core/raytrace/picture/display_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace tedavis::raytrace {
namespace {

TEST(DisplayLevels, AreThoseOfTheStandardOrOneBeside) {
    std::vector<unsigned char> memory(DisplayLevels::kEntries);
    base::Arena arena(memory.data(), memory.size());
    DisplayLevels levels;
    ASSERT_TRUE(levels.start(arena));
    int off = 0;
    for (int n = 0; n <= 100000; ++n) {
        const double light = n / 100000.0;
        const double shown = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
        const int level = levels.level(static_cast<float>(light)), right = static_cast<int>(255 * shown + 0.5);
        ASSERT_LE(std::abs(level - right), 1) << light;
        if (light > 0.1) off += level != right ? 1 : 0;
    }
    EXPECT_LT(off, 5000);
    EXPECT_EQ(levels.level(-3), 0);
    EXPECT_EQ(levels.level(std::nanf("")), 0);
    EXPECT_EQ(levels.level(7), 255);
    EXPECT_EQ(levels.level(std::numeric_limits<float>::infinity()), 255);
    std::vector<float> light;
    for (int n = -300; n < 700; ++n) light.push_back(static_cast<float>(n) / 500);
    light[5] = std::nanf("");
    std::vector<std::uint8_t> many(light.size());
    levels.set(light.data(), static_cast<std::uint32_t>(light.size()), many.data());
    for (std::size_t n = 0; n < light.size(); ++n) EXPECT_EQ(many[n], levels.level(light[n])) << light[n];
    DisplayLevels none;
    EXPECT_FALSE(none.start(arena));
}

}  // namespace
}  // namespace tedavis::raytrace
