// P35: terrain ahead, in pictures of the default design on three devices: said and colored on the ground that is in the way, and
// apart from plain relief. Controls: the same ground with an aircraft that nearly stands, and high above it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "host_sim/replay/display_session.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::test_terrain_alert_points {
namespace {

using test_support::kHillsNow;

constexpr host_sim::PictureSize kSize{640, 480};

struct Picture {
    host_sim::RgbaPicture pixels;
    display::FrameRecord record;

    [[nodiscard]] bool says_ahead() const {
        return std::any_of(record.flags.begin(), record.flags.end(),
                           [](const display::Name& flag) { return flag.view() == "terrain.ahead"; });
    }
};

/// Level over hills of 1000 m, with higher ones ahead.
Picture picture(const std::string& device, double msl_m, double speed_mps) {
    const test_support::TemporaryFolder folder;
    const auto& image = test_support::hills().image;
    host_sim::PictureOptions options;
    options.terrain = folder.write("hills.tdb", {image.begin(), image.end()});
    options.device = device;
    options.size = kSize;
    options.symbology = false;
    host_sim::DisplaySession session(options, false);
    flight::AircraftState state = test_support::aircraft_over_hills(msl_m, 30, 0);
    state.own_ship.velocity_north_mps *= speed_mps / 60;
    state.own_ship.velocity_east_mps *= speed_mps / 60;
    display::settle(session.display(), {state, {}, kHillsNow});
    session.display().plan({state, {}, kHillsNow});
    session.draw();
    return {upright(session.pixels()), session.display().record()};
}

/// Of the picture below the strip of notices: red or amber, shaded, which no ground of the design is.
double alarming_share(const Picture& picture) {
    std::size_t alarming = 0;
    const std::vector<std::uint8_t>& rgba = picture.pixels.pixels;
    for (std::size_t n = rgba.size() / 5; n + 3 < rgba.size(); n += 4)
        alarming += rgba[n] > rgba[n + 2] + 60 && rgba[n + 1] < rgba[n] + 30 ? 1u : 0u;
    return static_cast<double>(alarming) * 4 / static_cast<double>(rgba.size());
}

class TerrainAlertPoints : public testing::TestWithParam<const char*> {};

TEST_P(TerrainAlertPoints, P35GroundInTheWayIsColoredAndSaid) {
    constexpr double kLow_m = 1060, kHigh_m = 1700;
    const Picture alert = picture(GetParam(), kLow_m, 60), calm = picture(GetParam(), kLow_m, 10);
    EXPECT_TRUE(alert.says_ahead());
    EXPECT_NE(alert.record.alerts.terrain, policy::TerrainAhead::none);
    EXPECT_FALSE(calm.says_ahead());
    EXPECT_GT(alarming_share(alert), alarming_share(calm) + 0.003);
    EXPECT_LT(alarming_share(alert), 0.6) << "not all of the ground";
    const Picture high = picture(GetParam(), kHigh_m, 60);
    EXPECT_FALSE(high.says_ahead());
    EXPECT_LT(alarming_share(high), 0.0005) << "control: plain relief has no such color";
}

INSTANTIATE_TEST_SUITE_P(On, TerrainAlertPoints, testing::Values("es2-small", "es3-mid", "sc2"), [](const auto& of) {
    std::string name = of.param;
    for (char& c : name) c = c == '-' ? '_' : c;
    return name;
});

}  // namespace
}  // namespace tedavis::test_terrain_alert_points
