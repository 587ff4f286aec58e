// The runway as a pilot finds it (P28 .. P32) on three devices: by pixels at its place in the picture that are not there without
// it. Controls: a picture from which it is removed, or in which it stands elsewhere, is not taken for one that shows it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/draw/data/ground_section.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/display/point_pictures.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::test_runway_points {
namespace {

using base::kMetresPerNauticalMile;
using base::radians;
using draw::Rect;
using flight::Signal;
using test_support::gained_pixels;
using test_support::kHillsNow;
using test_support::PointPictures;

constexpr double kElevation_m = 500, kLength_m = 1800, kWidth_m = 45, kAiming_m = 300;
constexpr std::uint32_t kWidth = 640, kHeight = 480;
constexpr design::Color kPaint{245, 245, 245}, kRed{235, 30, 30}, kWhite{255, 255, 255};

/// A plain of slight waves round the runway.
const test_support::BuiltDatabase& plain() {
    static const test_support::BuiltDatabase built(test_support::make_raster(
        193, 257,
        [](std::uint32_t i, std::uint32_t j) {
            return static_cast<float>(kElevation_m + 4 * std::sin(i * 0.8) * std::cos(j * 0.7));
        },
        9.46, 47.3, 1.0 / 400));
    return built;
}

scene::ScenePoint threshold() { return test_support::scene_point(47.0, 9.7, static_cast<float>(kElevation_m)); }

/// To the north.
host_sim::LayerDraft runway() {
    host_sim::LayerDraft layer;
    layer.name = "runways";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::runway;
    layer.points = {threshold(), draw::moved(threshold(), {0, kLength_m})};
    layer.starts = {0, 2};
    layer.names = {"PLAIN 36/18"};
    host_sim::AttributeDraft width;
    width.name = "width";
    width.unit = "m";
    width.of = scene::AttributeOf::feature;
    width.values = {static_cast<float>(kWidth_m)};
    layer.attributes.push_back(width);
    return layer;
}

constexpr double kCrossing_m = 952, kCrossingHeight_m = 61;  // before the threshold, where an approach from a mile looks through

/// A flight across the approach, in the line of sight to the threshold.
host_sim::LayerDraft crossing_flight() {
    host_sim::LayerDraft layer;
    layer.name = "plan";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    for (const double aside_m : {-1500.0, 0.0, 1500.0}) {
        scene::ScenePoint at = draw::moved(threshold(), {aside_m, -kCrossing_m});
        at.height_m = static_cast<float>(kElevation_m + kCrossingHeight_m);
        layer.points.push_back(at);
    }
    layer.starts = {0, 3};
    return layer;
}

struct Place {
    double before_nm = 3, angle_deg = 3, aside_deg = 0;
};

/// On an approach from the south, on the path's extension to the aiming point.
flight::AircraftState on_approach(const Place& place) {
    flight::AircraftState state = test_support::aircraft_over_hills(1500, 0, -1);
    const double before_m = place.before_nm * kMetresPerNauticalMile, to_m = before_m + kAiming_m;
    const scene::ScenePoint at = draw::moved(threshold(), {to_m * std::tan(radians(place.aside_deg)), -before_m});
    const double msl_m = kElevation_m + to_m * std::tan(radians(place.angle_deg)) + to_m * to_m / (2 * 6.37e6);
    const double ellipsoid_m = msl_m + plain().database.undulation(at.latitude_rad, at.longitude_rad).m;
    const auto set = [&](Signal signal, double value) { state[signal] = {value, kHillsNow}; };
    set(Signal::latitude, at.latitude_rad);
    set(Signal::longitude, at.longitude_rad);
    set(Signal::ellipsoid_height, ellipsoid_m);
    set(Signal::baro_altitude, msl_m);
    set(Signal::height_above_terrain, msl_m - kElevation_m);
    state.own_ship.position = {at.latitude_rad, at.longitude_rad, {ellipsoid_m}};
    return state;
}

/// Around a place on the runway, metres before the threshold and to the right, as a level camera sees it.
Rect around(const Place& from, double before_m, double aside_m, float half_px) {
    const double focal_px = kWidth / 2.0 / std::tan(radians(30));
    const double distance_m = from.before_nm * kMetresPerNauticalMile - before_m;
    const double to_m = from.before_nm * kMetresPerNauticalMile + kAiming_m;
    const double height_m = to_m * std::tan(radians(from.angle_deg)) + to_m * to_m / (2 * 6.37e6);
    const double down = (height_m + distance_m * distance_m / (2 * 6.37e6)) / distance_m;
    const double y = kHeight / 2.0 + focal_px * std::tan(std::atan(down) - radians(1));
    const auto x = static_cast<float>(kWidth / 2.0 + focal_px * aside_m / distance_m);
    return {x - half_px, static_cast<float>(y) - half_px, 2 * half_px, 2 * half_px};
}

class RunwayPoints : public testing::TestWithParam<const char*> {
protected:
    struct Frame {
        host_sim::RgbaPicture picture;
        display::FrameRecord record;
    };
    /// With a scene of these layers; none: without a scene.
    Frame frame(const std::vector<host_sim::LayerDraft>& layers, const flight::AircraftState& state,
                const std::string& design = "") {
        const auto& image = plain().image;
        host_sim::PictureOptions options;
        options.terrain = folder_.write("plain.tdb", {image.begin(), image.end()});
        if (!layers.empty()) {
            const auto bytes = host_sim::sdb_bytes({"runway", "a test", 1, layers});
            options.scene = folder_.write("runway.sdb", {bytes.begin(), bytes.end()});
        }
        options.device = GetParam();
        if (!design.empty()) options.design = folder_.write("changed.toml", {design.begin(), design.end()});
        options.size = host_sim::PictureSize{kWidth, kHeight};
        options.symbology = false;
        host_sim::DisplaySession session(options, false);
        flight::PhaseStatus phase;
        phase.phase = flight::kApproachFinal;
        phase.source = flight::PhaseSource::switches;
        display::settle(session.display(), {state, phase, kHillsNow});
        session.display().plan({state, phase, kHillsNow});
        session.draw();
        return {upright(session.pixels()), session.display().record()};
    }
    PointPictures pictures(const Place& place) {
        const flight::AircraftState state = on_approach(place);
        return {frame({runway()}, state).picture, frame({}, state).picture};
    }

private:
    test_support::TemporaryFolder folder_;
};

/// Of the pictures, within a place, whatever the color.
std::size_t changed_pixels(const PointPictures& pictures, const Rect& place) {
    std::size_t changed = 0;
    for (auto y = static_cast<std::uint32_t>(place.y); y < static_cast<std::uint32_t>(place.bottom()); ++y)
        for (auto x = static_cast<std::uint32_t>(place.x); x < static_cast<std::uint32_t>(place.right()); ++x) {
            const std::size_t at = (std::size_t{y} * kWidth + x) * 4;
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(pictures.with.pixels[at + c] - pictures.without.pixels[at + c]));
            changed += most > 20 ? 1 : 0;
        }
    return changed;
}

/// The greatest gain of brightness by a pixel.
double contrast(const PointPictures& pictures, const Rect& place) {
    double most = 0;
    for (auto y = static_cast<std::uint32_t>(place.y); y < static_cast<std::uint32_t>(place.bottom()); ++y)
        for (auto x = static_cast<std::uint32_t>(place.x); x < static_cast<std::uint32_t>(place.right()); ++x) {
            const std::size_t at = (std::size_t{y} * kWidth + x) * 4;
            most = std::max<double>(most, pictures.with.pixels[at + 1] - pictures.without.pixels[at + 1]);
        }
    return most;
}

TEST_P(RunwayPoints, P28TheRunwayStandsOutAtTenMiles) {
    for (const double before_nm : {1.0, 5.0, 10.0}) {
        const Place place{before_nm, 3, 0};
        const PointPictures shown = pictures(place);
        const Rect at = around(place, -0.5 * kLength_m, 0, 6);
        EXPECT_GE(changed_pixels(shown, at), 12u) << before_nm;
        EXPECT_GT(contrast(shown, at), 60) << before_nm << ": the outline is light";
        EXPECT_EQ(changed_pixels(removed(shown), at), 0u) << "control, removed";
        EXPECT_LT(changed_pixels(moved(shown, at), at), 12u) << "control, moved";
    }
}

/// A tube that stands before it. Control: the tube covers the ground on both sides.
TEST_P(RunwayPoints, P28NoTubeHidesIt) {
    const Place place{1, 3, 0};
    const flight::AircraftState state = on_approach(place);
    const std::string tubes = "name = 'tubes'\nbased_on = '" + test_support::source_dir() +
                              "/configs/designs/default.toml'\n[[data.element]]\nname = 'trajectories'\ntechnique = "
                              "'tube'\nsize_m = 12\nopacity = 0.7\n";
    const PointPictures both{frame({runway()}, state, tubes).picture, frame({runway(), crossing_flight()}, state, tubes).picture};
    EXPECT_EQ(changed_pixels(both, around(place, -100, 0, 2)), 0u);
    for (const double aside_m : {-80.0, 80.0})
        EXPECT_GE(changed_pixels(both, around(place, -100, aside_m, 2)), 4u) << "control: " << aside_m;
}

TEST_P(RunwayPoints, P29MarkingsAreOnTheRunway) {
    const Place place{0.25, 3, 0};
    const PointPictures shown = pictures(place);
    const Rect stripes = around(place, -21, 0, 8), aiming = around(place, -322, 0, 14);
    for (const Rect& at : {stripes, aiming}) {
        const std::size_t painted = gained_pixels(shown, at, kPaint);
        EXPECT_GE(painted, 4u);
        EXPECT_LT(painted, changed_pixels(shown, at)) << "there is dark between them";
        EXPECT_LT(gained_pixels(removed(shown), at, kPaint), 4u) << "control, removed";
    }
}

TEST_P(RunwayPoints, P30TheExtendedCenterLineLeadsToIt) {
    const Place place{3, 3, 0};
    const PointPictures shown = pictures(place);
    for (const double before_nm : {0.5, 1.0, 2.0}) {
        const Rect at = around(place, before_nm * kMetresPerNauticalMile, 0, 4);
        EXPECT_GE(changed_pixels(shown, at), 4u) << before_nm;
        EXPECT_EQ(changed_pixels(removed(shown), at), 0u) << "control, removed";
    }
    const auto width = [&](double before_nm) {
        const Rect at = around(place, before_nm * kMetresPerNauticalMile, 0, 14);
        return changed_pixels(shown, at);
    };
    EXPECT_GT(width(2), width(1.5)) << "there is a tick at each mile";
}

TEST_P(RunwayPoints, P31TheLightsTellTheAngleAndNeedAPosition) {
    const auto reds = [&](const Place& place, base::SignalState own = base::SignalState::valid) {
        flight::AircraftState state = on_approach(place);
        state.own_ship.state = own;
        const PointPictures shown{frame({runway()}, state).picture, frame({}, state).picture};
        const Rect at = around(place, -kAiming_m, -70, 26);
        return std::pair(gained_pixels(shown, at, kRed), gained_pixels(shown, at, kWhite));
    };
    const auto low = reds({3, 2, 0}), on_path = reds({3, 3, 0}), high = reds({3, 4, 0});
    EXPECT_GE(low.first, 4 * 4u);
    EXPECT_GE(on_path.first, 2 * 4u);
    EXPECT_LT(on_path.first, low.first);
    EXPECT_EQ(high.first, 0u);
    EXPECT_GT(high.second, low.second);
    EXPECT_EQ(reds({3, 2, 0}, base::SignalState::stale).first, 0u) << "control: an old position";
    EXPECT_EQ(reds({11, 2, 0}).first, 0u) << "control: too far";
}

TEST_P(RunwayPoints, P32TheSignFadesNearTheRunway) {
    EXPECT_EQ(frame({runway()}, on_approach({6, 3, 0})).record.labels.placed, 1u);
    EXPECT_EQ(frame({runway()}, on_approach({1.2, 3, 0})).record.labels.placed, 0u);
    const Place place{6, 3, 0};
    const PointPictures shown = pictures(place);
    Rect at = around(place, -0.5 * kLength_m, 0, 60);
    at.height = 54;  // above the runway
    EXPECT_GE(gained_pixels(shown, at, kWhite), 20u);
    EXPECT_EQ(gained_pixels(removed(shown), at, kWhite), 0u) << "control, removed";
}

INSTANTIATE_TEST_SUITE_P(On, RunwayPoints, testing::Values("es2-small", "es3-mid", "sc2"), [](const auto& of) {
    std::string name = of.param;
    for (char& c : name) c = c == '-' ? '_' : c;
    return name;
});

}  // namespace
}  // namespace tedavis::test_runway_points
