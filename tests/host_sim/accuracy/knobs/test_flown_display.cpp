#include "host_sim/accuracy/knobs/flown_display.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_flown_display {
namespace {

FlownDisplay of_size(std::uint32_t width, std::uint32_t height) {
    FlownDisplay display;
    display.size = {width, height};
    return display;
}

TEST(FlownDisplay, ItsGridHasTheShapeOfThePicture) {
    const SeenGrid usual = seen_grid({});
    EXPECT_EQ(usual.across, 32u);
    EXPECT_EQ(usual.down, 18u);
    EXPECT_NEAR(usual.field_of_view_deg, 60, 1e-9) << "of the default design";
    EXPECT_EQ(seen_grid(of_size(1000, 1000)).down, 32u);
    EXPECT_EQ(seen_grid(of_size(1000, 500), 128).down, 64u);
    EXPECT_EQ(of_size(1000, 500).share(0.75).height, 375u);
}

TEST(FlownDisplay, AnErrorHasMorePixelsOnALargerPicture) {
    EXPECT_DOUBLE_EQ(pixel_scale({}), 1);
    EXPECT_DOUBLE_EQ(pixel_scale(of_size(1280, 720)), 2);
    EXPECT_DOUBLE_EQ(pixel_scale(of_size(320, 180)), 1) << "never less than what was measured";
}

TEST(FlownDisplay, IsToldApartByWhatItsFilesSay) {
    FlownDisplay cruise, desktop;
    cruise.design = "cruise";
    desktop.device = "desktop";
    EXPECT_EQ(identity_of({}), identity_of({}));
    EXPECT_NE(identity_of(cruise), identity_of({}));
    EXPECT_NE(identity_of(desktop), identity_of({}));
    EXPECT_NE(identity_of(of_size(1280, 720)), identity_of({}));
}

TEST(FlownDisplay, IsToldApartByTheDesignsOfItsPhases) {
    const test_support::TemporaryFolder place;
    FlownDisplay phased;
    phased.design = place.write("phased.toml", "name = \"phased\"\n[phases]\ncruise = \"cruising.toml\"\n");
    static_cast<void>(place.write("cruising.toml", "name = \"cruising\"\n"));
    const std::uint64_t before = identity_of(phased);
    static_cast<void>(seen_grid(phased));
    static_cast<void>(place.write("cruising.toml", "name = \"cruising\"\n[view]\nhorizontal_field_of_view_deg = 40\n"));
    EXPECT_NE(identity_of(phased), before);
    test_support::expect_user_error([&] { static_cast<void>(seen_grid(phased)); }, "'cruising' has another field of view");
    static_cast<void>(place.write("cruising.toml", "name = \"cruising\"\n[view]\nmode = \"map\"\n"));
    test_support::expect_user_error([&] { static_cast<void>(seen_grid(phased)); }, "its phase's design 'cruising' shows a map");
}

TEST(FlownDisplay, RefusesAMap) {
    FlownDisplay map;
    map.design = "map_north_up";
    test_support::expect_user_error([&] { static_cast<void>(seen_grid(map)); }, "--design map_north_up: shows a map");
    map.design = "no_such_design";
    test_support::expect_user_error([&] { static_cast<void>(seen_grid(map)); }, "no_such_design");
}

}  // namespace
}  // namespace tedavis::host_sim::test_flown_display
