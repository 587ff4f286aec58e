// Spatial data as pilots know them, in pictures of the default design on three devices: storm cells with the line of their
// motion, wind, other aircraft. Controls: the same picture without the layer, and one in which it is another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/display/point_pictures.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::test_data_points {
namespace {

using base::radians;
using draw::Rect;
using test_support::gained_pixels;
using test_support::kHillsNow;

constexpr host_sim::PictureSize kSize{640, 480};
constexpr double kHeading_deg = 30, kLatitude_deg = 47.0, kLongitude_deg = 9.7;
constexpr double kEye_m = 1500;
constexpr Rect kWhole{0, 0, 640, 480};

/// So far ahead of the own ship and to its right.
scene::ScenePoint place(double ahead_m, double right_m, float height_m) {
    const double turn = radians(kHeading_deg), metres = 111'200;
    const double north_m = ahead_m * std::cos(turn) - right_m * std::sin(turn);
    const double east_m = ahead_m * std::sin(turn) + right_m * std::cos(turn);
    return test_support::scene_point(kLatitude_deg + north_m / metres,
                                     kLongitude_deg + east_m / (metres * std::cos(radians(kLatitude_deg))), height_m);
}

host_sim::AttributeDraft value_of(const char* name, float value) {
    host_sim::AttributeDraft attribute;
    attribute.name = name;
    attribute.of = scene::AttributeOf::feature;
    attribute.values = {value};
    return attribute;
}

/// 2 km wide and 8 km ahead; it moves to the right.
host_sim::LayerDraft cell(float dbz, float speed_mps) {
    host_sim::LayerDraft layer;
    layer.name = "storm";
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::storm_cell;
    layer.height_datum = scene::HeightDatum::msl;
    layer.points = {place(7000, -2000, 0), place(7000, 0, 0), place(9000, 0, 0), place(9000, -2000, 0)};
    layer.starts = {0, 4};
    layer.attributes = {value_of("intensity", dbz), value_of("floor", 1600), value_of("ceiling", 2750),
                        value_of("speed", speed_mps), value_of("toward", static_cast<float>(radians(kHeading_deg + 90)))};
    layer.attributes[0].unit = "dBZ";
    for (host_sim::AttributeDraft& attribute : layer.attributes) attribute.uncertainty_all = scene::Uncertainty::from_level(0);
    return layer;
}

/// Twelve knots from the left, wherever the eye looks.
host_sim::LayerDraft wind() {
    host_sim::LayerDraft layer;
    layer.name = "wind";
    layer.shape = scene::LayerShape::grid;
    layer.role = scene::LayerRole::wind;
    layer.grid = {radians(9.6), radians(47.25), radians(0.02), radians(0.02), 16, 16, 1, 1};
    for (const char* name : {"east", "north"}) {
        host_sim::AttributeDraft attribute;
        attribute.name = name;
        attribute.unit = "m/s";
        attribute.values.assign(256, name[0] == 'e' ? 5.3f : -3.1f);
        attribute.uncertainty_all = scene::Uncertainty::from_level(0);
        layer.attributes.push_back(attribute);
    }
    return layer;
}

flight::TrafficReport aircraft(double ahead_m, double over_m, double climb_mps = 0) {
    flight::TrafficReport report;
    report.address = 0x4b1234;
    const scene::ScenePoint at = place(ahead_m, 0, 0);
    report.place = {at.latitude_rad, at.longitude_rad, kHillsNow, 0, 0, 0};
    report.place.height_m =
        static_cast<float>(kEye_m + test_support::hills().database.undulation(at.latitude_rad, at.longitude_rad).m + over_m);
    report.ground_speed_mps = 60;
    report.climb_mps = static_cast<float>(climb_mps);
    report.true_track_rad = static_cast<float>(radians(kHeading_deg));
    return report;
}

using Change = std::function<void(flight::AircraftState&)>;
void nothing(flight::AircraftState&) {}

host_sim::RgbaPicture picture(const std::string& device, const std::vector<host_sim::LayerDraft>& layers,
                              const Change& change = nothing) {
    const test_support::TemporaryFolder folder;
    const auto& image = test_support::hills().image;
    host_sim::PictureOptions options;
    options.terrain = folder.write("hills.tdb", {image.begin(), image.end()});
    if (!layers.empty()) {
        const auto bytes = host_sim::sdb_bytes({"one", "a test", 1, layers});
        options.scene = folder.write("scene.sdb", {bytes.begin(), bytes.end()});
    }
    options.device = device;
    options.size = kSize;
    options.symbology = false;
    host_sim::DisplaySession session(options, false);
    flight::AircraftState state = test_support::aircraft_over_hills(kEye_m, kHeading_deg);
    change(state);
    display::settle(session.display(), {state, {}, kHillsNow});
    session.display().plan({state, {}, kHillsNow});
    session.draw();
    return upright(session.pixels());
}

struct Extent {
    int left = 10'000, right = -1;
    [[nodiscard]] int width() const { return right - left; }
};
/// Of the pixels that differ by more than dithering.
Extent changed(const host_sim::RgbaPicture& first, const host_sim::RgbaPicture& second) {
    Extent extent;
    for (std::uint32_t y = 0; y < first.height; ++y)
        for (std::uint32_t x = 0; x < first.width; ++x) {
            const std::size_t at = (std::size_t{y} * first.width + x) * 4;
            int difference = 0;
            for (std::size_t c = 0; c < 3; ++c) difference += std::abs(first.pixels[at + c] - second.pixels[at + c]);
            if (difference < 24) continue;
            extent.left = std::min(extent.left, static_cast<int>(x));
            extent.right = std::max(extent.right, static_cast<int>(x));
        }
    return extent;
}

class DataPoints : public testing::TestWithParam<const char*> {};

/// Shares of light behind the cell. Control: a cell of another class.
TEST_P(DataPoints, StormCellsHaveRadarColorsAndLetTheSkyThrough) {
    const host_sim::RgbaPicture none = picture(GetParam(), {}), red = picture(GetParam(), {cell(45, 0)}),
                                yellow = picture(GetParam(), {cell(35, 0)});
    const auto mean = [](const host_sim::RgbaPicture& of, std::size_t channel) {
        double sum = 0;
        for (std::uint32_t y = 175; y < 205; ++y)
            for (std::uint32_t x = 280; x < 300; ++x) sum += of.pixels[(std::size_t{y} * of.width + x) * 4 + channel];
        return sum / 600;
    };
    EXPECT_GT(mean(red, 0), mean(red, 1) + 15) << "red over blue sky";
    EXPECT_GT(mean(yellow, 1), mean(red, 1) + 30) << "control";
    EXPECT_GT(mean(red, 2), 0.3 * mean(none, 2)) << "the sky shows through";
}

/// What motion adds: opaque, thin, to the right of the cell, and narrower than the cell itself. Control: a cell that stands.
TEST_P(DataPoints, TheMotionOfACellIsALineNoLongerThanTheCell) {
    const host_sim::RgbaPicture none = picture(GetParam(), {}), stands = picture(GetParam(), {cell(45, 0)}),
                                moves = picture(GetParam(), {cell(45, 4)});
    const Extent storm = changed(none, stands), line = changed(stands, moves);
    ASSERT_GT(storm.width(), 60);
    EXPECT_GE(line.left, storm.right - 6) << "from its front on";
    EXPECT_GT(line.width(), 0.5 * storm.width());
    EXPECT_LT(line.width(), 1.1 * storm.width());
    const Rect all{0, 0, 640, 480};
    const std::size_t gained = gained_pixels({moves, stands}, all, {0xe6, 0x0c, 0x10});
    EXPECT_GT(gained, static_cast<std::size_t>(line.width()) / 2) << "in the cell's opaque color";
    EXPECT_LT(gained, static_cast<std::size_t>(8 * line.width())) << "a line, not a solid";
    EXPECT_EQ(gained_pixels({stands, stands}, all, {0xe6, 0x0c, 0x10}), 0u) << "control";
}

/// Light strokes with dark rims, on sky and ground alike.
TEST_P(DataPoints, WindIsBarbsThatStandOut) {
    const host_sim::RgbaPicture with = picture(GetParam(), {wind()}), without = picture(GetParam(), {});
    EXPECT_GE(gained_pixels({with, without}, kWhole, {0xf4, 0xf6, 0xfa}), 20u);
    EXPECT_GE(gained_pixels({with, without}, kWhole, {0, 0, 0}), 20u) << "rims";
    EXPECT_LT(gained_pixels({with, without}, kWhole, {0xf4, 0xf6, 0xfa}), 640u * 480 / 50) << "few";
    EXPECT_EQ(gained_pixels({without, without}, kWhole, {0xf4, 0xf6, 0xfa}), 0u) << "control";
}

/// Filled within 6 NM and 1200 ft. Control: the same aircraft at the same place on the screen, but farther away or higher up.
TEST_P(DataPoints, P34TrafficIsShownByThreat) {
    const auto pixels = [](const char* device, double ahead_m, double over_m) {
        const host_sim::RgbaPicture with = picture(device, {}, [&](flight::AircraftState& state) {
            state.traffic.is_received = true;
            static_cast<void>(state.traffic.reports.try_push_back(aircraft(ahead_m, over_m)));
        });
        return gained_pixels({with, picture(device, {})}, {240, 20, 160, 300}, {0x60, 0xe0, 0xff});
    };
    const std::size_t proximate = pixels(GetParam(), 10'000, 200), far = pixels(GetParam(), 12'000, 240),
                      high = pixels(GetParam(), 10'000, 400);
    EXPECT_GT(far, 20u);
    EXPECT_GT(high, 20u);
    EXPECT_GT(proximate, far + far / 4);
    EXPECT_GT(proximate, high + high / 4);
}

/// White letters beside the diamond, in rows above it and below it.
struct HeightText {
    std::size_t above = 0, below = 0;
};
HeightText height_text(const host_sim::RgbaPicture& with, const host_sim::RgbaPicture& without) {
    constexpr design::Color kDiamond{0x60, 0xe0, 0xff}, kText{255, 255, 255};
    const auto gained = [&](float from_y, float to_y, design::Color color) {
        return gained_pixels({with, without}, {240, from_y, 160, to_y - from_y}, color);
    };
    float top = 20, bottom = 400;
    while (top < bottom && gained(top, top + 1, kDiamond) == 0) ++top;
    while (bottom > top && gained(bottom - 1, bottom, kDiamond) == 0) --bottom;
    return {gained(top - 40, top, kText), gained(bottom, bottom + 40, kText)};
}

/// Controls: the same aircraft lower, and level.
TEST_P(DataPoints, P34TheRelativeHeightStandsOnItsSideWithAnArrowForItsTrend) {
    const host_sim::RgbaPicture without = picture(GetParam(), {});
    const auto text = [&](double over_m, double climb_mps) {
        return height_text(picture(GetParam(), {},
                                   [&](flight::AircraftState& state) {
                                       state.traffic.is_received = true;
                                       static_cast<void>(state.traffic.reports.try_push_back(aircraft(4000, over_m, climb_mps)));
                                   }),
                           without);
    };
    const HeightText higher = text(150, 0), lower = text(-150, 0), climbing = text(150, 5), descending = text(150, -5);
    EXPECT_GT(higher.above, 20u);
    EXPECT_EQ(higher.below, 0u);
    EXPECT_GT(lower.below, 20u);
    EXPECT_EQ(lower.above, 0u);
    EXPECT_GT(climbing.above, higher.above + 4);
    EXPECT_GT(descending.above, higher.above + 4);
}

INSTANTIATE_TEST_SUITE_P(On, DataPoints, testing::Values("es2-small", "es3-mid", "sc2"), [](const auto& of) {
    std::string name = of.param;
    for (char& c : name) c = c == '-' ? '_' : c;
    return name;
});

}  // namespace
}  // namespace tedavis::test_data_points
