// How often the terrain alert is false, over flights that somebody flew and the mountains that were below them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/terrain.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::test_terrain_alerts {
namespace {

template <class Command>
nlohmann::json run(Command command) {
    const auto done = test_support::run_command(command, true);
    EXPECT_EQ(done.code, 0) << done.results;
    return done.json();
}

/// While it crosses the raster of Davos northbound, above all mountains.
TEST(TerrainAlerts, AFlightHighAboveDavosHasNone) {
    const std::string data = test_support::real_data_dir();
    const test_support::TemporaryFolder folder;
    host_sim::TerrainBuildOptions build;
    build.rasters = {data + "/terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif"};
    build.output = folder.file("t.tdb");
    static_cast<void>(run([&](host_sim::Console& console) { return run_terrain_build(build, console); }));
    host_sim::ConvertOptions convert;
    convert.flight = data + "/flights/adsb_switzerland_map.json.gz";
    convert.aircraft = "4b1c22";
    convert.assume_geometric = true;
    convert.output = folder.file("flight.log");
    static_cast<void>(run([&](host_sim::Console& console) { return run_convert(convert, console); }));
    host_sim::ReplayOptions replay;
    replay.log = convert.output;
    replay.output = folder.file("run");
    replay.picture.terrain = build.output;
    replay.picture.device = "es2-small";
    replay.from_s = 10600;
    replay.to_s = 11000;
    replay.step_s = 2;
    replay.frames = host_sim::FrameOutput::none;
    const nlohmann::json alerts = run([&](host_sim::Console& console) { return run_replay(replay, console); })["terrain_alerts"];
    EXPECT_NEAR(alerts["hours"].get<double>(), 400 / 3600.0, 0.002);
    EXPECT_EQ(alerts["count"], 0);
    EXPECT_EQ(alerts["seconds_caution"].get<double>() + alerts["seconds_warning"].get<double>(), 0);
}

}  // namespace
}  // namespace tedavis::test_terrain_alerts
