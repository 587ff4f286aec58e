// P33: a cable is a barrier, in pictures of the default design on three devices: a translucent wall from the line between the
// tops of its poles down to the drawn ground, with a solid upper edge, in the color of its alert. Controls: its poles alone, and
// the picture without it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "render_core/design/warning_bands.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/display/point_pictures.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::test_cable_points {
namespace {

using base::radians;
using draw::Rect;
using test_support::gained_pixels;
using test_support::kHillsNow;

constexpr host_sim::PictureSize kSize{640, 480};
constexpr double kHeading_deg = 30, kPitch_deg = 2, kLatitude_deg = 47.0, kLongitude_deg = 9.7;
constexpr double kGround_m = 1000, kEye_m = 1700, kSpeed_mps = 60, kHalfSpan_m = 900;
constexpr float kTop_m = 1690;
constexpr design::Color kRed = design::kWarningGround, kAmber = design::kCautionGround;

const test_support::BuiltDatabase& plain() {
    static const test_support::BuiltDatabase built(test_support::make_raster(
        193, 257,
        [](std::uint32_t i, std::uint32_t j) {
            return static_cast<float>(kGround_m + 4 * std::sin(i * 0.8) * std::cos(j * 0.7));
        },
        9.46, 47.3, 1.0 / 400));
    return built;
}

scene::ScenePoint place(double ahead_m, double right_m) {
    const double turn = radians(kHeading_deg), metres = 111'200;
    const double north_m = ahead_m * std::cos(turn) - right_m * std::sin(turn);
    const double east_m = ahead_m * std::sin(turn) + right_m * std::cos(turn);
    return test_support::scene_point(kLatitude_deg + north_m / metres,
                                     kLongitude_deg + east_m / (metres * std::cos(radians(kLatitude_deg))), kTop_m);
}

/// Two poles on either side of the track, with a cable or without.
host_sim::LayerDraft layer_of(double ahead_m, bool has_cable) {
    host_sim::LayerDraft layer;
    layer.name = "cables";
    layer.shape = has_cable ? scene::LayerShape::lines : scene::LayerShape::points;
    layer.role = scene::LayerRole::obstacle;
    layer.height_datum = scene::HeightDatum::msl;
    layer.points = {place(ahead_m, -kHalfSpan_m), place(ahead_m, kHalfSpan_m)};
    if (has_cable) layer.starts = {0, 2};
    return layer;
}

/// Where a pinhole of 60 degrees sees a place.
struct Pixel {
    double x = 0, y = 0;
};
Pixel pixel(double ahead_m, double right_m, double msl_m) {
    const double focal_px = kSize.width / 2.0 / std::tan(radians(30)), pitch = radians(kPitch_deg), down_m = kEye_m - msl_m;
    const double depth_m = ahead_m * std::cos(pitch) - down_m * std::sin(pitch);
    return {kSize.width / 2.0 + focal_px * right_m / depth_m,
            kSize.height / 2.0 + focal_px * (down_m * std::cos(pitch) + ahead_m * std::sin(pitch)) / depth_m};
}

struct Picture {
    host_sim::RgbaPicture pixels;
    policy::TerrainAhead alert = policy::TerrainAhead::none;
};

Picture picture(const std::string& device, const host_sim::LayerDraft* layer) {
    const test_support::TemporaryFolder folder;
    const auto& image = plain().image;
    host_sim::PictureOptions options;
    options.terrain = folder.write("plain.tdb", {image.begin(), image.end()});
    if (layer != nullptr) {
        const auto bytes = host_sim::sdb_bytes({"one", "a test", 1, {*layer}});
        options.scene = folder.write("scene.sdb", {bytes.begin(), bytes.end()});
    }
    options.device = device;
    options.size = kSize;
    options.symbology = false;
    host_sim::DisplaySession session(options, false);
    const flight::AircraftState state = test_support::aircraft_over_hills(kEye_m, kHeading_deg, kPitch_deg);
    display::settle(session.display(), {state, {}, kHillsNow});
    session.display().plan({state, {}, kHillsNow});
    session.draw();
    return {upright(session.pixels()), session.display().record().alerts.obstacle};
}

class CablePoints : public testing::TestWithParam<const char*> {
protected:
    /// Share of the rows of a column in which a picture differs from the one without obstacles.
    [[nodiscard]] double changed_share(const host_sim::RgbaPicture& with, double x, double from_y, double to_y) const {
        int changed = 0, rows = 0;
        for (auto y = static_cast<std::uint32_t>(from_y); y < static_cast<std::uint32_t>(to_y); ++y, ++rows) {
            const std::size_t at = (std::size_t{y} * with.width + static_cast<std::uint32_t>(x)) * 4;
            int difference = 0;
            for (std::size_t c = 0; c < 3; ++c) difference += std::abs(with.pixels[at + c] - without_.pixels.pixels[at + c]);
            changed += difference >= 12 ? 1 : 0;
        }
        return rows == 0 ? 0 : static_cast<double>(changed) / rows;
    }
    [[nodiscard]] std::size_t gained(const Picture& with, const Rect& where, design::Color color) const {
        return gained_pixels({with.pixels, without_.pixels}, where, color);
    }

    Picture without_ = picture(GetParam(), nullptr);
};

constexpr double kAmberAhead_m = 45 * kSpeed_mps, kRedAhead_m = 20 * kSpeed_mps, kCalmAhead_m = 75 * kSpeed_mps;

/// Columns between the poles, but for the middle, where the cable's sign stands.
TEST_P(CablePoints, P33ACableIsAWallFromTheLineBetweenTopsToTheDrawnGround) {
    for (const double ahead_m : {kAmberAhead_m, kCalmAhead_m}) {
        const host_sim::LayerDraft cable = layer_of(ahead_m, true), poles = layer_of(ahead_m, false);
        const Picture with = picture(GetParam(), &cable), control = picture(GetParam(), &poles);
        for (const double share : {-0.8, -0.5, -0.3, 0.3, 0.5, 0.8}) {
            const double right_m = share * kHalfSpan_m;
            const Pixel top = pixel(ahead_m, right_m, static_cast<double>(kTop_m)), foot = pixel(ahead_m, right_m, kGround_m);
            ASSERT_GT(foot.y, top.y + 40);
            EXPECT_GT(changed_share(with.pixels, top.x, top.y + 4, foot.y - 4), 0.99) << ahead_m << " " << share;
            EXPECT_EQ(changed_share(with.pixels, top.x, foot.y + 5, foot.y + 60), 0) << "it ends on the ground";
            EXPECT_EQ(changed_share(with.pixels, top.x, top.y - 40, top.y - 10), 0) << "and at the line";
            EXPECT_EQ(changed_share(control.pixels, top.x, top.y - 40, foot.y + 60), 0) << "control";
        }
    }
}

TEST_P(CablePoints, P33TheEdgeIsSolidAndTheWallTranslucentInTheColorOfTheAlert) {
    const auto beside = [](double ahead_m, double from_m, double to_m) {
        const Pixel from = pixel(ahead_m, 0.3 * kHalfSpan_m, from_m), to = pixel(ahead_m, 0.7 * kHalfSpan_m, to_m);
        return Rect{static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(to.x - from.x),
                    static_cast<float>(to.y - from.y)};
    };
    const auto edge = [&](double ahead_m) {
        Rect at = beside(ahead_m, static_cast<double>(kTop_m), static_cast<double>(kTop_m));
        at.y -= 6;
        at.height = 12;
        return at;
    };
    const auto wall = [&](double ahead_m) { return beside(ahead_m, 1600, 1100); };
    for (const bool is_near : {false, true}) {
        const double ahead_m = is_near ? kRedAhead_m : kAmberAhead_m;
        const design::Color color = is_near ? kRed : kAmber;
        const host_sim::LayerDraft cable = layer_of(ahead_m, true), poles = layer_of(ahead_m, false);
        const Picture with = picture(GetParam(), &cable), control = picture(GetParam(), &poles);
        EXPECT_EQ(with.alert, is_near ? policy::TerrainAhead::warning : policy::TerrainAhead::caution);
        EXPECT_GE(gained(with, edge(ahead_m), color), static_cast<std::size_t>(2 * edge(ahead_m).width)) << "opaque";
        EXPECT_EQ(gained(with, wall(ahead_m), color), 0u) << "what is behind shows through";
        EXPECT_EQ(gained(control, edge(ahead_m), color), 0u) << "control";
    }
    const host_sim::LayerDraft far = layer_of(kCalmAhead_m, true);
    const Picture calm = picture(GetParam(), &far);
    EXPECT_EQ(calm.alert, policy::TerrainAhead::none);
    EXPECT_EQ(gained(calm, edge(kCalmAhead_m), kAmber) + gained(calm, edge(kCalmAhead_m), kRed), 0u);
}

INSTANTIATE_TEST_SUITE_P(On, CablePoints, testing::Values("es2-small", "es3-mid", "sc2"), [](const auto& of) {
    std::string name = of.param;
    for (char& c : name) c = c == '-' ? '_' : c;
    return name;
});

}  // namespace
}  // namespace tedavis::test_cable_points
