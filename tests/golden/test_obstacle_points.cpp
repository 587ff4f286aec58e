// P33: obstacles by what lies ahead, in pictures of the default design on three devices: red within half a minute, amber within a
// minute, in their own color beyond; the symbol is by type and height. Controls: the same obstacle lower, or an aircraft that
// stands, and the picture without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "render_core/design/warning_bands.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/display/point_pictures.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::test_obstacle_points {
namespace {

using base::radians;
using draw::Rect;
using test_support::gained_pixels;
using test_support::kHillsNow;

constexpr host_sim::PictureSize kSize{640, 480};
constexpr double kHeading_deg = 30, kLatitude_deg = 47.0, kLongitude_deg = 9.7;
constexpr double kEye_m = 1700, kSpeed_mps = 60;  // high above the hills: there is no terrain alert
constexpr Rect kAhead{240, 160, 160, 200};
constexpr design::Color kRed = design::kWarningGround, kAmber = design::kCautionGround, kOwn{0xE8, 0xE4, 0xD8};

struct Obstacle {
    double after_s = 20;
    float top_msl_m = 1690;
    std::string kind = "mast";
};

/// So far ahead of the own ship, on its track.
host_sim::LayerDraft layer_of(const Obstacle& obstacle) {
    const double north_m = kSpeed_mps * obstacle.after_s * std::cos(radians(kHeading_deg));
    const double east_m = kSpeed_mps * obstacle.after_s * std::sin(radians(kHeading_deg));
    constexpr double kMetres = 111'200;
    host_sim::LayerDraft layer;
    layer.name = "obstacles";
    layer.role = scene::LayerRole::obstacle;
    layer.height_datum = scene::HeightDatum::msl;
    layer.points = {test_support::scene_point(kLatitude_deg + north_m / kMetres,
                                              kLongitude_deg + east_m / (kMetres * std::cos(radians(kLatitude_deg))),
                                              obstacle.top_msl_m)};
    host_sim::AttributeDraft kind;
    kind.name = "kind";
    kind.scale = scene::AttributeScale::nominal;
    kind.of = scene::AttributeOf::feature;
    kind.classes = {"mast", "turbine"};
    kind.values = {obstacle.kind == "mast" ? 0.0f : 1.0f};
    layer.attributes = {kind};
    return layer;
}

struct Picture {
    host_sim::RgbaPicture pixels;
    display::FrameRecord record;

    [[nodiscard]] bool says(std::string_view flag) const {
        return std::any_of(record.flags.begin(), record.flags.end(),
                           [&](const display::Name& one) { return one.view() == flag; });
    }
};

Picture picture(const std::string& device, const Obstacle* obstacle, double speed_mps = kSpeed_mps, double turn_deg_s = 0) {
    const test_support::TemporaryFolder folder;
    const auto& image = test_support::hills().image;
    host_sim::PictureOptions options;
    options.terrain = folder.write("hills.tdb", {image.begin(), image.end()});
    if (obstacle != nullptr) {
        const auto bytes = host_sim::sdb_bytes({"one", "a test", 1, {layer_of(*obstacle)}});
        options.scene = folder.write("scene.sdb", {bytes.begin(), bytes.end()});
    }
    options.device = device;
    options.size = kSize;
    options.symbology = false;
    host_sim::DisplaySession session(options, false);
    flight::AircraftState state = test_support::aircraft_over_hills(kEye_m, kHeading_deg);
    state.own_ship.velocity_north_mps *= speed_mps / kSpeed_mps;
    state.own_ship.velocity_east_mps *= speed_mps / kSpeed_mps;
    state[flight::Signal::heading_rate] = {radians(turn_deg_s), kHillsNow};
    display::settle(session.display(), {state, {}, kHillsNow});
    session.display().plan({state, {}, kHillsNow});
    session.draw();
    return {upright(session.pixels()), session.display().record()};
}

class ObstaclePoints : public testing::TestWithParam<const char*> {};

TEST_P(ObstaclePoints, P33ObstaclesInTheWayAreRedOrAmberByTheirTime) {
    const Picture without = picture(GetParam(), nullptr);
    ASSERT_FALSE(without.says("obstacle.ahead") || without.says("terrain.ahead"));
    const auto gained = [&](const Picture& with, design::Color color) {
        return gained_pixels({with.pixels, without.pixels}, kAhead, color);
    };
    const Obstacle near_one{20}, later{45}, far{75}, low{20, 1500};
    const Picture warned = picture(GetParam(), &near_one), cautioned = picture(GetParam(), &later),
                  calm = picture(GetParam(), &far), below = picture(GetParam(), &low),
                  standing = picture(GetParam(), &near_one, 0);
    EXPECT_TRUE(warned.says("obstacle.ahead"));
    EXPECT_EQ(warned.record.alerts.obstacle, policy::TerrainAhead::warning);
    EXPECT_GE(gained(warned, kRed), 40u);
    EXPECT_EQ(gained(warned, kAmber), 0u);
    EXPECT_EQ(cautioned.record.alerts.obstacle, policy::TerrainAhead::caution);
    EXPECT_GE(gained(cautioned, kAmber), 30u);
    EXPECT_EQ(gained(cautioned, kRed), 0u);
    for (const Picture* const control : {&calm, &below, &standing}) {
        EXPECT_FALSE(control->says("obstacle.ahead"));
        EXPECT_EQ(gained(*control, kRed) + gained(*control, kAmber), 0u);
        EXPECT_GE(gained(*control, kOwn), 15u) << "in its own color";
    }
}

/// What lies straight ahead in a turn counts for twice its time.
TEST_P(ObstaclePoints, P33InATurnAnObstacleStraightAheadIsAmberWhereItWouldBeRed) {
    const Obstacle near_one{20}, later{45};
    const Picture turning = picture(GetParam(), &near_one, kSpeed_mps, 9), control = picture(GetParam(), &near_one);
    EXPECT_EQ(turning.record.alerts.obstacle, policy::TerrainAhead::caution);
    EXPECT_EQ(control.record.alerts.obstacle, policy::TerrainAhead::warning);
    ASSERT_FALSE(turning.record.alerts.obstacles.all().empty());
    EXPECT_NEAR(turning.record.alerts.obstacles.all()[0].seconds(), control.record.alerts.obstacles.all()[0].seconds(), 0.15);
    EXPECT_FALSE(picture(GetParam(), &later, kSpeed_mps, 9).says("obstacle.ahead"));
}

/// Pixels in which two pictures differ by more than dithering.
std::size_t changed_pixels(const host_sim::RgbaPicture& a, const host_sim::RgbaPicture& b) {
    std::size_t changed = 0;
    for (std::size_t at = 0; at + 3 < a.pixels.size(); at += 4) {
        int difference = 0;
        for (std::size_t c = 0; c < 3; ++c) difference += std::abs(a.pixels[at + c] - b.pixels[at + c]);
        changed += difference > 96 ? 1u : 0u;
    }
    return changed;
}

TEST_P(ObstaclePoints, P33TheSymbolIsByTypeAndHeight) {
    const Obstacle mast{75, 1690, "mast"}, turbine{75, 1690, "turbine"}, lower{75, 1250, "mast"};
    const host_sim::RgbaPicture high = picture(GetParam(), &mast).pixels;
    EXPECT_GE(changed_pixels(high, picture(GetParam(), &turbine).pixels), 20u);
    EXPECT_GE(changed_pixels(high, picture(GetParam(), &lower).pixels), 20u);
    EXPECT_EQ(changed_pixels(high, picture(GetParam(), &mast).pixels), 0u) << "control";
}

INSTANTIATE_TEST_SUITE_P(On, ObstaclePoints, testing::Values("es2-small", "es3-mid", "sc2"), [](const auto& of) {
    std::string name = of.param;
    for (char& c : name) c = c == '-' ? '_' : c;
    return name;
});

}  // namespace
}  // namespace tedavis::test_obstacle_points
