#include "host_sim/replay/legend_pictures.hpp"

#include <gtest/gtest.h>

#include "host_sim/replay/flight_player.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_legend_pictures {
namespace {

struct Flown {
    explicit Flown(PictureSize size = {640, 480}) : options(of_size(files.options("run"), size)) {}
    static ReplayOptions of_size(ReplayOptions options, PictureSize size) {
        options.picture.size = size;
        return options;
    }

    test_support::FlownFiles files;
    ReplayOptions options;
    DisplaySession session{options.picture, false};
    FlightPlayer player{{options.log, options.picture.bus, "", options.switch_config}, session.display()};

    [[nodiscard]] flight::FrameInput at(double seconds) {
        return player.at(player.first() + base::Duration::from_seconds(seconds));
    }
    /// The same instant as the display draws it by itself.
    [[nodiscard]] std::string drawn(flight::FrameInput input, flight::LegendShow legend) {
        input.legend = legend;
        input.trail = nullptr;
        display::settle(session.display(), input);
        session.display().plan(input);
        session.draw();
        return encode_small_png(session.pixels());
    }
};

TEST(LegendPictures, ShowTheSecondFrameOfADesignWithTheWholeLegend) {
    Flown flown;
    LegendPictures pictures;
    for (std::uint64_t n = 0; n < 4; ++n)
        pictures.note("default", test_support::frame_result(n, static_cast<double>(n)), flown.at(1 + static_cast<double>(n)));
    RunStory story(base::Time{0});
    pictures.draw(flown.session, story);
    ASSERT_EQ(story.legends().size(), 1u);
    const RunStory::Legend& legend = story.legends()[0];
    EXPECT_EQ(legend.design, "default");
    EXPECT_EQ(legend.frame, 1u);
    EXPECT_TRUE(legend.is_whole);
    EXPECT_EQ(legend.png, flown.drawn(flown.at(2), flight::LegendShow::whole));
    EXPECT_NE(legend.png, flown.drawn(flown.at(2), flight::LegendShow::key)) << "control";
}

TEST(LegendPictures, ARunOfOneFrameHasOneAndASmallDisplayIsStated) {
    Flown flown({320, 240});
    LegendPictures pictures;
    pictures.note("default", test_support::frame_result(0, 0), flown.at(1));
    RunStory story(base::Time{0});
    pictures.draw(flown.session, story);
    ASSERT_EQ(story.legends().size(), 1u);
    EXPECT_EQ(story.legends()[0].frame, 0u);
    EXPECT_FALSE(story.legends()[0].is_whole);
}

TEST(LegendPictures, AreOfAFewDesignsAndTheOthersAreCounted) {
    Flown flown;
    LegendPictures pictures;
    const flight::FrameInput input = flown.at(1);
    for (std::uint64_t n = 0; n < LegendPictures::kMaxDesigns + 3; ++n)
        pictures.note("design " + std::to_string(n), test_support::frame_result(n, static_cast<double>(n)), input);
    EXPECT_EQ(pictures.frames_left_out(), 3u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_legend_pictures
