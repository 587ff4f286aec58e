// The shipped contract of the default design over a flight that somebody flew, and the mountains that were below it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host_sim/commands/contract.hpp"
#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/terrain.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::test_flown_contracts {
namespace {

template <class Command>
void run(Command command) {
    EXPECT_EQ(test_support::run_command(command).code, 0);
}

/// While it crosses the raster of Davos northbound. There are no data but terrain: conditions on data have nothing to measure.
TEST(FlownContracts, TheDefaultDesignsHoldsOverAFlightOverDavos) {
    const std::string data = test_support::real_data_dir();
    const test_support::TemporaryFolder folder;
    host_sim::TerrainBuildOptions build;
    build.rasters = {data + "/terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif"};
    build.output = folder.file("t.tdb");
    run([&](host_sim::Console& console) { return run_terrain_build(build, console); });
    host_sim::ConvertOptions convert;
    convert.flight = data + "/flights/adsb_switzerland_map.json.gz";
    convert.aircraft = "4b1c22";
    convert.assume_geometric = true;
    convert.output = folder.file("flight.log");
    run([&](host_sim::Console& console) { return run_convert(convert, console); });
    host_sim::ReplayOptions replay;
    replay.log = convert.output;
    replay.output = folder.file("run");
    replay.picture.terrain = build.output;
    replay.picture.device = "desktop";
    replay.picture.size = {1024, 768};
    replay.from_s = 10600;
    replay.to_s = 11000;
    replay.step_s = 25;
    replay.layers = true;
    run([&](host_sim::Console& console) { return run_replay(replay, console); });

    const auto judged = test_support::run_command(
        [&](host_sim::Console& console) {
            return run_contract(host_sim::ContractOptions{replay.output, "default", "", 0}, console);
        },
        true);
    EXPECT_EQ(judged.code, 0) << judged.results;
    std::size_t held = 0;
    const auto json = judged.json();
    for (const auto& condition : json["conditions"]) held += condition["state"] == "holds" ? 1 : 0;
    EXPECT_GE(held, 7u) << "clutter, instruments and colours are measured";
}

}  // namespace
}  // namespace tedavis::test_flown_contracts
