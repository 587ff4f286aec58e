#include "host_sim/replay/scanned_flight.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scanned_flight {
namespace {

ScannedFlight scanned(const std::string& log) {
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    ReplayOptions options;
    options.log = log;
    return scan_flight(player_files(options), console);
}

TEST(ScannedFlight, HasThePlacesThatWereFlown) {
    const test_support::FlownFiles files;
    const ScannedFlight flight = scanned(files.log);
    const test_support::FlownCircle flown;
    EXPECT_TRUE(flight.is_dated);
    EXPECT_NEAR((flight.last - flight.first).to_seconds(), 8, 0.2);
    ASSERT_GE(flight.places.size(), 7u) << "one each second, but where none was sent yet";
    for (const ScannedPlace& place : flight.places) {
        const SignalSample sample = flown.at(place.time + flight.ahead).value();
        const earth::Geodetic expected{sample[flight::Signal::latitude], sample[flight::Signal::longitude], {}};
        EXPECT_LT(earth::surface_distance_m(expected, {place.latitude_rad, place.longitude_rad, {}}), 5);
        EXPECT_NEAR(place.height_m, sample[flight::Signal::ellipsoid_height], 2);
    }
    EXPECT_FALSE(std::filesystem::exists(files.log + ".tdx")) << "the index belongs to the runs over their terrain";
}

TEST(ScannedFlight, WhatIsNoLogIsRefused) {
    const test_support::TemporaryFolder folder;
    test_support::expect_user_error([&] { (void)scanned(folder.file("none.log")); }, "none.log");
    test_support::expect_user_error([&] { (void)scanned(folder.write("text.log", "no frame\n")); }, "no CAN frame in this file");
}

}  // namespace
}  // namespace tedavis::host_sim::test_scanned_flight
