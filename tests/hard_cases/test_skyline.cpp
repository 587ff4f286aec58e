// The mountains on the display are those of the raster: in the default flight, every column's skyline against a ray cast.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/replay/flight_player.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/terrain/skyline.hpp"

namespace tedavis::test_skyline {
namespace {

using test_support::SkylinePicture;

constexpr double kTolerance_px = 2;
constexpr int kColumnStride = 16;

struct Count {
    int columns = 0, within = 0, without_terrain = 0;
};

/// `yaw_deg` turns the oracle's camera: the control.
Count compare(const SkylinePicture& picture, const test_support::RasterRayCaster& caster, double yaw_deg) {
    test_support::OracleCamera camera = picture.camera();
    const glm::dvec3 up = glm::normalize(camera.eye);
    const auto turned = [&](const glm::dvec3& v) {
        const double a = base::radians(yaw_deg);
        return v * std::cos(a) - glm::cross(up, v) * std::sin(a) + up * glm::dot(up, v) * (1 - std::cos(a));
    };
    camera.forward = turned(camera.forward);
    camera.right = turned(camera.right);
    camera.down = turned(camera.down);
    Count count;
    for (int column = 0; column < static_cast<int>(camera.width); column += kColumnStride) {
        const auto drawn = picture.skyline_px(column);
        const auto cast = caster.skyline_px(camera, column);
        ++count.columns;
        count.within += drawn.has_value() == cast.has_value() && (!drawn || std::abs(*drawn - *cast) <= kTolerance_px) ? 1 : 0;
        count.without_terrain += drawn ? 0 : 1;
    }
    return count;
}

TEST(Skyline, OfTheDefaultFlightIsThatOfARayCast) {
    const test_support::RecordedFlight flight = test_support::default_flight();
    const test_support::TemporaryFolder folder;
    test_support::DefaultTerrain terrain;
    test_support::HeadlessDisplay headless("egl", "es3-mid", 1024, 768, &terrain.bytes, test_support::garish_design());
    host_sim::FlightPlayer player({folder.write("flight.log", flight.log), "canaerospace", "", "one_hot"}, headless.display());
    const host_sim::Raster raster =
        host_sim::load_rasters({test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif"}, {});
    const test_support::RasterRayCaster caster(raster);

    Count all, control;
    for (double second = 15; second < 390; second += 25) {
        const base::Time now = player.first() + base::Duration::from_seconds(second);
        const SkylinePicture picture(headless, player.at(now).state, now);
        ASSERT_GT(picture.record().terrain.triangles, 0u) << second;
        const Count count = compare(picture, caster, 0);
        all.columns += count.columns;
        all.within += count.within;
        all.without_terrain += count.without_terrain;
        if (second == 90) control = compare(picture, caster, 1);
    }
    EXPECT_GE(all.within, 0.99 * all.columns) << all.within << " of " << all.columns;
    EXPECT_LT(all.without_terrain, all.columns / 4);
    EXPECT_LT(control.within, 0.9 * control.columns) << "control: turned by one degree the skylines must differ";
    RecordProperty("columns", all.columns);
    RecordProperty("within", all.within);
}

}  // namespace
}  // namespace tedavis::test_skyline
