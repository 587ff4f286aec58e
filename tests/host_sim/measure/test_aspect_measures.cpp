#include "host_sim/measure/aspect_measures.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_aspect_measures {
namespace {

template <class LevelAt>
RgbaPicture grey(std::uint32_t width, std::uint32_t height, LevelAt level_at) {
    RgbaPicture made{width, height, {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const auto level = static_cast<std::uint8_t>(level_at(x, y));
            for (const std::uint8_t byte : {level, level, level, std::uint8_t{255}}) made.pixels.push_back(byte);
        }
    return made;
}

TEST(AspectMeasures, EdgesAreWhereLightnessChanges) {
    EXPECT_EQ(edge_density(view_of(grey(40, 20, [](auto, auto) { return 90; }))), 0);
    const RgbaPicture step = grey(40, 20, [](std::uint32_t x, auto) { return x < 20 ? 90 : 140; });
    EXPECT_DOUBLE_EQ(edge_density(view_of(step)), 2.0 / 40) << "a column on each side";
    const RgbaPicture turned = grey(20, 40, [](auto, std::uint32_t y) { return y < 20 ? 90 : 140; });
    EXPECT_DOUBLE_EQ(edge_density(view_of(turned)), 2.0 / 40);
    EXPECT_EQ(edge_density(view_of(grey(256, 8, [](std::uint32_t x, auto) { return 60 + x / 8; }))), 0) << "too faint";
}

TEST(AspectMeasures, ColorsCountWhereTheGroundWas) {
    const RgbaPicture bare = grey(8, 8, [](std::uint32_t x, auto) { return x < 6 ? 40 : 200 + x; });
    const RgbaPicture data = grey(
        8, 8, [](std::uint32_t x, std::uint32_t y) { return y < 4 ? (x < 6 ? 40u : 200 + x) : 100 + x % 3 + (x < 6 ? 0 : 50); });
    EXPECT_EQ(distinct_colors(view_of(data), view_of(bare), {40, 40, 40}), 3u) << "not those over the text on the right";
    EXPECT_EQ(distinct_colors(view_of(bare), view_of(bare), {40, 40, 40}), 0u);
    EXPECT_EQ(distinct_colors(view_of(data), view_of(bare), {41, 40, 40}), 0u);
    const RgbaPicture other = grey(4, 8, [](auto, auto) { return 0; });
    test_support::expect_user_error([&] { static_cast<void>(distinct_colors(view_of(data), view_of(other), {})); }, "sizes");
}

}  // namespace
}  // namespace tedavis::host_sim::test_aspect_measures
