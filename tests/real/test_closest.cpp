// Where a flight that somebody flew came closest to the mountains, against a search in the raster by GDAL and the flight's log.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/terrain.hpp"
#include "tests/real/raster_heights.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::test_closest {
namespace {

constexpr double kFrom_s = 10600, kTo_s = 11000;

template <class Command>
void run(Command command) {
    const auto done = test_support::run_command(command, true);
    EXPECT_EQ(done.code, 0) << done.results;
}

/// The flight over Davos, with a frame every `step_s`.
struct DavosRun {
    explicit DavosRun(double step_s) {
        const std::string data = test_support::real_data_dir();
        host_sim::TerrainBuildOptions build;
        build.rasters = {raster};
        build.output = folder.file("t.tdb");
        run([&](host_sim::Console& console) { return run_terrain_build(build, console); });
        host_sim::ConvertOptions convert;
        convert.flight = data + "/flights/adsb_switzerland_map.json.gz";
        convert.aircraft = "4b1c22";
        convert.assume_geometric = true;
        convert.output = folder.file("flight.log");
        run([&](host_sim::Console& console) { return run_convert(convert, console); });
        replay.log = convert.output;
        replay.output = folder.file("run");
        replay.picture.terrain = build.output;
        replay.picture.device = "es2-small";
        replay.from_s = kFrom_s;
        replay.to_s = kTo_s;
        replay.frames = host_sim::FrameOutput::none;
        replay.step_s = step_s;
        run([&](host_sim::Console& console) { return run_replay(replay, console); });
    }
    const std::string raster = test_support::real_data_dir() + "/terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif";
    test_support::TemporaryFolder folder;
    host_sim::ReplayOptions replay;
};

/// The oracle knows the places of dense frames and the raster alone; the run under test has a frame every 100 s.
TEST(Closest, OverDavosIsThatOfABruteForceSearchOverRasterAndTrack) {
    const DavosRun sparse(100), dense(1);
    const test_support::RasterHeights heights(sparse.raster);
    double least_m = INFINITY, least_s = 0;
    const auto lines = test_support::frame_lines(dense.replay.output);
    for (std::size_t n = 0; n + 1 < lines.size(); ++n)
        for (int step = 0; step < 100; ++step) {
            const auto between = [&](const char* key) {
                const double from = lines[n]["own_ship"][key], to = lines[n + 1]["own_ship"][key];
                return from + step / 100.0 * (to - from);
            };
            const double above_m = between("alt_msl_m") - heights.at(between("lat_deg"), between("lon_deg"));
            if (above_m < least_m) least_m = above_m, least_s = lines[n]["time_s"].get<double>() + step / 100.0;
        }
    const auto closest = test_support::summary_of(sparse.replay.output)["closest"];
    ASSERT_GE(closest["by_height"].size(), 1u);
    const auto& first = closest["by_height"][0];
    EXPECT_NEAR(first["height_above_terrain_m"].get<double>(), least_m, 1);
    EXPECT_NEAR(first["time_s"].get<double>(), least_s, 1);
    EXPECT_LE(closest["by_distance"][0]["nearest"]["distance_m"].get<double>(), least_m + 0.05);
    EXPECT_EQ(first["alert"], "none");
}

}  // namespace
}  // namespace tedavis::test_closest
