#include "host_sim/accuracy/knobs/crack_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_crack_knob {
namespace {

TEST(CrackKnob, TheTerrainHasNone) {
    const test_support::ShippedKnobGround shipped;
    const auto knob = make_crack_knob(shipped.quick());
    const ErrorDistribution errors = test_support::errors_of(*knob, 0);
    EXPECT_EQ(errors.max, 0);
    EXPECT_GT(errors.count, 2u) << "poses that show ground";
    const auto picture = knob->picture(0, 0);
    ASSERT_TRUE(picture);
    const std::vector<KnobPixel> sky = {{160, 5}};
    EXPECT_EQ(cracks_among(sky, view_of(*picture), view_of(*picture)).size(), 1u) << "control: the background itself";
}

TEST(CracksAmong, FindsThePixelsOfTheBackground) {
    RgbaPicture background{4, 2, std::vector<std::uint8_t>(32, 255)};
    for (std::size_t pixel = 0; pixel < 8; ++pixel) background.pixels[4 * pixel + 1] = 0;
    background.pixels[4 * 7] = 10;  // a legend
    RgbaPicture drawn = background;
    for (const std::size_t pixel : {1u, 2u, 6u}) drawn.pixels[4 * pixel] = 10;
    const std::vector<KnobPixel> asked = {{1, 0}, {2, 0}, {3, 0}, {2, 1}, {3, 1}};
    const std::vector<KnobPixel> cracks = cracks_among(asked, view_of(drawn), view_of(background));
    ASSERT_EQ(cracks.size(), 1u);
    EXPECT_EQ(cracks[0].x, 3u);
    EXPECT_EQ(cracks[0].y, 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_crack_knob
