#include "host_sim/reports/callouts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tedavis::host_sim::test_callouts {
namespace {

std::vector<Callout> random_callouts(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> x(0, 960), y(0, 540);
    std::vector<Callout> callouts;
    for (std::size_t n = 0; n < count; ++n) callouts.push_back({"part " + std::to_string(n), {x(random), y(random)}});
    return callouts;
}

TEST(Callouts, NamesNeverOverlapNorLeaveThePicture) {
    for (unsigned seed = 1; seed <= 20; ++seed)
        for (const std::size_t count : {1u, 7u, 44u, 90u}) {
            const CalloutLayout layout = lay_out_callouts(random_callouts(count, seed), 960, 540);
            ASSERT_EQ(layout.placed.size(), count);
            for (const PlacedCallout& one : layout.placed) {
                EXPECT_GE(one.from.y, 0.49f * layout.text_px);
                EXPECT_LE(one.from.y, 540 - 0.49f * layout.text_px);
                EXPECT_GE(one.text.x, 0);
                for (const PlacedCallout& other : layout.placed)
                    if (&one != &other && one.is_left == other.is_left)
                        EXPECT_GE(std::fabs(one.from.y - other.from.y), 1.2f * layout.text_px);
            }
        }
}

TEST(Callouts, OnASideNamesAreInTheOrderOfTheirPlaces) {
    const std::vector<Callout> callouts = random_callouts(40, 5);
    const CalloutLayout layout = lay_out_callouts(callouts, 960, 540);
    std::size_t left = 0;
    for (std::size_t a = 0; a < callouts.size(); ++a) {
        left += layout.placed[a].is_left ? 1 : 0;
        for (std::size_t b = 0; b < callouts.size(); ++b) {
            if (layout.placed[a].is_left == layout.placed[b].is_left && callouts[a].at.y < callouts[b].at.y)
                EXPECT_LT(layout.placed[a].from.y, layout.placed[b].from.y);
            if (layout.placed[a].is_left && !layout.placed[b].is_left) EXPECT_LE(callouts[a].at.x, callouts[b].at.x);
        }
    }
    EXPECT_EQ(left, 20u);
}

TEST(Callouts, LinesEndAtTheirPlaces) {
    RgbaPicture grey{100, 80, std::vector<std::uint8_t>(100 * 80 * 4, 128)};
    const std::vector<Callout> callouts = {{"a", {30, 20}}, {"b", {80, 60}}};
    const RgbaPicture drawn = draw_callouts(grey, callouts);
    const CalloutLayout layout = lay_out_callouts(callouts, 100, 80);
    EXPECT_EQ(drawn.width, 100 + 2 * layout.margin_px);
    EXPECT_EQ(drawn.height, 80u);
    const auto red_at = [&](float x, float y) {
        return drawn.pixels[(static_cast<std::size_t>(y) * drawn.width + layout.margin_px + static_cast<std::size_t>(x)) * 4];
    };
    EXPECT_EQ(red_at(30, 20), 0);
    EXPECT_EQ(red_at(80, 60), 0);
    EXPECT_EQ(red_at(50, 75), 128) << "control: the picture stays elsewhere";
}

}  // namespace
}  // namespace tedavis::host_sim::test_callouts
