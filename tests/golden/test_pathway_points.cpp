// P27: the planned path as frames of 700 x 200 ft, whose edges stand in the picture where a pinhole camera sees them, and which
// hide nothing behind them. Controls: frames of another size, and the tube that has been there before.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/display/point_pictures.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::test_pathway_points {
namespace {

using base::radians;
using test_support::kHillsNow;

constexpr double kFeet_m = 0.3048, kHalfWidth_m = 350 * kFeet_m, kHalfHeight_m = 100 * kFeet_m;
constexpr double kNear_m = 800, kSpacing_m = 463;  // to the nearest frame, and to the one at the path's end
constexpr double kHeight_m = 1500, kAbove_m = 25;  // of the path; of the eye above it, which is out of the tube
constexpr double kFieldOfView_deg = 60;
constexpr design::Color kColor{0xf0, 0xa0, 0x20, 255};  // of the designs data/pathway and data/tube

/// Level, from 3 km behind the own ship to the second frame ahead.
host_sim::SceneDraft planned() {
    host_sim::LayerDraft layer;
    layer.name = "flight";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.height_datum = scene::HeightDatum::msl;
    for (const double ahead_m : {-3000.0, -1000.0, 0.0, 400.0, kNear_m + kSpacing_m}) {
        const double latitude_deg = 47 + base::degrees(ahead_m / earth::meridian_radius_m(radians(47.0)));
        layer.points.push_back(test_support::scene_point(latitude_deg, 9.7, static_cast<float>(kHeight_m)));
    }
    layer.starts = {0, 5};
    return {"pathway", "a test", 1, {layer}};
}

struct Picture {
    host_sim::RgbaPicture pixels;

    [[nodiscard]] bool is_colored(double x, double y) const {
        const std::size_t at = (std::size_t(y) * pixels.width + std::size_t(x)) * 4;
        return test_support::is_of_color(&pixels.pixels[at], kColor);
    }
    [[nodiscard]] double focal_px() const { return pixels.width / 2.0 / std::tan(radians(kFieldOfView_deg / 2)); }
    /// Share of the places along the edge of a frame that have its color, within a pixel and a half.
    [[nodiscard]] double edge_share(double ahead_m, double size = 1) const {
        const double half_x = size * focal_px() * kHalfWidth_m / ahead_m, half_y = size * focal_px() * kHalfHeight_m / ahead_m;
        const double down = focal_px() * kAbove_m / ahead_m;
        int colored = 0, all = 0;
        for (double share = -0.95; share < 0.96; share += 0.05, all += 4)
            for (const double side : {-1.0, 1.0}) {
                colored += has_color_near(share * half_x, down + side * half_y) ? 1 : 0;
                colored += has_color_near(side * half_x, down + share * half_y) ? 1 : 0;
            }
        return static_cast<double>(colored) / all;
    }
    /// Share of the pixels within the farther frame that have its color.
    [[nodiscard]] double filled_share() const {
        const double half_x = focal_px() * kHalfWidth_m / (kNear_m + kSpacing_m) - 3,
                     half_y = focal_px() * kHalfHeight_m / (kNear_m + kSpacing_m) - 3,
                     down = focal_px() * kAbove_m / (kNear_m + kSpacing_m);
        int colored = 0, all = 0;
        for (double y = -half_y; y <= half_y; ++y)
            for (double x = -half_x; x <= half_x; ++x, ++all)
                colored += is_colored(pixels.width / 2.0 + x, pixels.height / 2.0 + down + y) ? 1 : 0;
        return static_cast<double>(colored) / all;
    }

private:
    [[nodiscard]] bool has_color_near(double off_x, double off_y) const {
        for (const double dx : {-1.5, -0.5, 0.5, 1.5})
            for (const double dy : {-1.5, -0.5, 0.5, 1.5})
                if (is_colored(pixels.width / 2.0 + off_x + dx, pixels.height / 2.0 + off_y + dy)) return true;
        return false;
    }
};

using DeviceAndSize = std::tuple<const char*, host_sim::PictureSize>;

class PathwayPoints : public testing::TestWithParam<DeviceAndSize> {
protected:
    Picture picture_of(const std::string& design, bool is_valid = true) {
        const auto& terrain = test_support::hills().image;
        host_sim::PictureOptions options;
        options.terrain = folder_.write("hills.tdb", {terrain.begin(), terrain.end()});
        const auto scene = host_sim::sdb_bytes(planned());
        options.scene = folder_.write("flight.sdb", {scene.begin(), scene.end()});
        options.device = std::get<0>(GetParam());
        options.size = std::get<1>(GetParam());
        options.design = design;
        options.symbology = false;
        options.legend = flight::LegendShow::none;
        host_sim::DisplaySession session(options, false);
        flight::AircraftState state = test_support::aircraft_over_hills(kHeight_m + kAbove_m, 0, 0);
        if (!is_valid) state.own_ship.state = base::SignalState::lost;
        display::settle(session.display(), {state, {}, kHillsNow});
        session.display().plan({state, {}, kHillsNow});
        session.draw();
        return {upright(session.pixels())};
    }

    test_support::TemporaryFolder folder_;
};

TEST_P(PathwayPoints, P27FramesStandWhereTheyAreSeenAndHideNothing) {
    const Picture frames = picture_of("data/pathway");
    for (const double ahead_m : {kNear_m, kNear_m + kSpacing_m}) {
        EXPECT_GT(frames.edge_share(ahead_m), 0.95) << ahead_m;
        EXPECT_LT(frames.edge_share(ahead_m, 1.4), 0.5)
            << "control: a frame of another size, which meets dashes and the other frame";
    }
    EXPECT_EQ(frames.filled_share(), 0);
    const std::string tube =
        "name = 'tube'\n[[data.element]]\nrole = 'trajectory'\ntechnique = 'tube'\ncolor = '#f0a020'\nsize_m = 20\n";
    EXPECT_GT(picture_of(folder_.write("tube.toml", {tube.begin(), tube.end()})).filled_share(), 0.1)
        << "control: the tube hides what is behind it";
}

TEST_P(PathwayPoints, P27NoFrameIsShownWithoutAPlace) {
    const Picture lost = picture_of("data/pathway", false);
    EXPECT_EQ(lost.edge_share(kNear_m), 0);
    EXPECT_EQ(lost.edge_share(kNear_m + kSpacing_m), 0);
}

std::string name_of(const testing::TestParamInfo<DeviceAndSize>& of) {
    std::string name = std::get<0>(of.param);
    for (char& c : name) c = c == '-' ? '_' : c;
    return name + "_" + std::to_string(std::get<1>(of.param).width);
}

INSTANTIATE_TEST_SUITE_P(On, PathwayPoints,
                         testing::Combine(testing::Values("es2-small", "es3-mid", "sc2"),
                                          testing::Values(host_sim::PictureSize{640, 480}, host_sim::PictureSize{800, 450},
                                                          host_sim::PictureSize{480, 640})),
                         name_of);

}  // namespace
}  // namespace tedavis::test_pathway_points
