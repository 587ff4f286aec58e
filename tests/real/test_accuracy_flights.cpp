// The bound of the terrain's error along flights that somebody recorded, over the mountains that they crossed: no sample of a
// million lies above it.
#include <gtest/gtest.h>

#include <sstream>

#include "host_sim/accuracy/flight_errors.hpp"
#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/trace.hpp"
#include "host_sim/terrain_builder/terrain_build.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_accuracy_flights {
namespace {

constexpr const char* kFlights = "/flights/adsb_switzerland_map.json.gz";
constexpr const char* kDavos = "/terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif";

TEST(AccuracyFlights, NoSampleOfARecordedFlightOverDavosIsAboveTheBound) {
    const test_support::TemporaryFolder folder;
    std::ostringstream results, notes;
    Console console{results, notes, true, false};
    ConvertOptions convert;
    convert.flight = test_support::real_data_dir() + kFlights;
    convert.aircraft = "4b1c22";
    convert.output = folder.file("flight.log");
    ASSERT_EQ(run_convert(convert, console), 0) << notes.str();
    base::SerialWorkers workers;
    const TracedGround ground(database_of({"", test_support::real_data_dir() + kDavos}, folder.file("."), console), workers);
    const RecordedPoses recorded = read_recorded_poses({convert.output, "canaerospace", "", "one_hot"}, ground.path(), console);
    for (const AircraftPose& pose : recorded.valid) {
        ASSERT_GT(pose.latitude_deg, 46.49) << "where the terrain is";
        ASSERT_LT(pose.latitude_deg, 47.11);
    }
    FlightErrorsPlan plan;
    plan.moments = 30;
    plan.line_poses = 10;
    plan.across = 300;
    plan.progress = [](std::size_t, std::size_t) {};
    const FlightErrors errors = measure_flight_errors({ground, true, &recorded, {}}, plan);
    EXPECT_TRUE(errors.holds());
    EXPECT_GT(errors.samples(), 1'000'000u);
    const Tightness tight = errors.tightness();
    EXPECT_GT(tight.max, 0.2) << "control: the samples come near the bound";
    for (const ToleranceLine& line : errors.lines)
        std::printf("%5g px asked, %.3f proven, %.3f measured, %llu samples, tight %.2f %.2f\n", line.asked_px, line.proven_px,
                    line.measured_px, static_cast<unsigned long long>(line.samples), line.tightness.median, line.tightness.max);
    FlightErrors broken = errors;
    broken.moments.front().proven_px = 0.5 * broken.moments.front().measured_px - broken.known_to_px;
    EXPECT_FALSE(broken.holds()) << "control: a bound of half the error";
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy_flights
