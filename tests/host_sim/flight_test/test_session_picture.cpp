#include "host_sim/flight_test/session_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "render_core/display/planner/picture_layer.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::host_sim::test_session_picture {
namespace {

class SessionPictures : public ::testing::Test {
protected:
    static PictureOptions small_device() {
        PictureOptions options;
        options.device = "es2-small";
        return options;
    }
    void plan(double pitch_deg) {
        session_.display().plan({test_support::scene_state(90, pitch_deg, 0),
                                 flight::stated_phase(flight::kApproachFinal, flight::PhaseSource::can),
                                 test_support::kSceneNow});
        picture_.begin_frame();
    }
    DisplaySession session_{small_device(), true};
    SessionPicture picture_{session_};
};

TEST_F(SessionPictures, ArePixelsLayersAndRecordOfThePlannedFrame) {
    plan(0);
    EXPECT_FALSE(picture_.is_drawn()) << "nobody asked for it";
    const RgbaPicture pixels = picture_.pixels();
    EXPECT_TRUE(picture_.is_drawn());
    EXPECT_EQ(pixels.pixels, upright(session_.pixels()).pixels);
    const LayerMask& layers = picture_.layers();
    ASSERT_EQ(layers.layers.size(), std::size_t{pixels.width} * pixels.height);
    EXPECT_EQ(layers.names.at(static_cast<std::size_t>(display::PictureLayer::symbology)), "symbology");
    const auto of_symbology = std::count(layers.layers.begin(), layers.layers.end(), std::uint8_t{4});
    EXPECT_GT(of_symbology, 1000) << "instruments are drawn";
    EXPECT_LT(of_symbology, static_cast<std::ptrdiff_t>(layers.layers.size()));
    EXPECT_EQ(upright(session_.pixels()).pixels, pixels.pixels) << "the layers leave the whole picture";
    EXPECT_EQ(picture_.frame().phase, "approach.final");
    EXPECT_EQ(picture_.frame().design, "approach");
    EXPECT_EQ(picture_.frame().layers, layers.names);
    EXPECT_TRUE(picture_.frame().obstacles) << "a contract can ask for them";
}

TEST_F(SessionPictures, OfALaterFrameAreOthers) {
    plan(0);
    const RgbaPicture before = picture_.pixels();
    plan(12);
    EXPECT_NE(picture_.pixels().pixels, before.pixels);
}

}  // namespace
}  // namespace tedavis::host_sim::test_session_picture
