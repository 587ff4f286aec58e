#include "host_sim/importers/igc_importer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_igc_importer {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

const std::string kHead = "AXXX001\r\nHFDTE120420\r\nHFALGALTGPS:ELL\r\n";

RecordedFlight flight_of(const std::string& text) { return import_igc(text, "t.igc").flights.at(0); }

TEST(IgcImporter, ReadsAFixToItsLastDigit) {
    const RecordedFlight flight = flight_of(kHead + "B0947004637500N00955250EA0123401300\r\n");
    ASSERT_EQ(flight.fixes.size(), 1u);
    const RecordedFix& fix = flight.fixes[0];
    EXPECT_EQ(fix.time.ns, 1586684820 * std::int64_t{1'000'000'000});
    EXPECT_NEAR(base::degrees(fix.latitude_rad), 46.625, 1e-12);
    EXPECT_NEAR(base::degrees(fix.longitude_rad), 9.9208333333333333, 1e-12);
    EXPECT_EQ(fix.pressure_altitude_m, 1234.0);
    EXPECT_EQ(fix.gnss_height_m, 1300.0);
    EXPECT_EQ(flight.gnss_datum, HeightDatum::wgs84_ellipsoid);
}

TEST(IgcImporter, TakesSouthWestAndHeightsBelowTheDatum) {
    const RecordedFix fix = flight_of(kHead + "B0947003330000S07040000WA-0012-0034\n").fixes.at(0);
    EXPECT_NEAR(base::degrees(fix.latitude_rad), -33.5, 1e-12);
    EXPECT_NEAR(base::degrees(fix.longitude_rad), -70.66666666666667, 1e-12);
    EXPECT_EQ(fix.pressure_altitude_m, -12.0);
    EXPECT_EQ(fix.gnss_height_m, -34.0);
}

TEST(IgcImporter, UsesExtensionsOfTheIRecord) {
    // LAD and LOD: one more digit each; GSP with five digits: 12.34 km/h; TRT: three.
    const RecordedFix fix =
        flight_of(kHead + "I043636LAD3737LOD3842GSP4345TRT\nB0947004637500N00955250EA01234013007501234090\n").fixes.at(0);
    EXPECT_NEAR(base::degrees(fix.latitude_rad), 46 + 37.5007 / 60, 1e-12);
    EXPECT_NEAR(base::degrees(fix.longitude_rad), 9 + 55.2505 / 60, 1e-12);
    EXPECT_NEAR(*fix.true_track_rad, base::kPi / 2, 1e-12);
    EXPECT_NEAR(*fix.ground_speed_mps, 12.34 / 3.6, 1e-9);
}

TEST(IgcImporter, GoesOnAfterMidnight) {
    const RecordedFlight flight = flight_of(kHead + "B2359594637500N00955250EA0123401300\nB0000014637500N00955250EA0123401300\n");
    ASSERT_EQ(flight.fixes.size(), 2u);
    EXPECT_EQ((flight.fixes[1].time - flight.fixes[0].time).ns, 2'000'000'000);
}

TEST(IgcImporter, SkipsStepsBackAndBrokenRecordsAndCountsThem) {
    const ImportedFile file = import_igc(
        kHead +
            "B0947004637500N00955250EA0123401300\nB0946504637500N00955250EA0123401300\nB09470\n"
            "B0947024697500N00955250EA0123401300\nB0947034637500X00955250EA0123401300\nB0947044637500N00955250EA0123401300\n",
        "t.igc");
    EXPECT_EQ(file.flights[0].fixes.size(), 2u);
    EXPECT_THAT(file.notes, Contains(HasSubstr("1 B records step back")));
    EXPECT_THAT(file.notes, Contains(HasSubstr("3 B records are malformed")));
}

TEST(IgcImporter, DropsTheGnssHeightOfAFixWithout3D) {
    const RecordedFlight flight = flight_of(kHead + "B0947004637500N00955250EA0123401300\nB0947014637500N00955250EV0123409999\n");
    EXPECT_TRUE(flight.fixes[0].gnss_height_m);
    EXPECT_FALSE(flight.fixes[1].gnss_height_m);
    EXPECT_TRUE(flight.fixes[1].pressure_altitude_m);
}

TEST(IgcImporter, BelievesWhatTheHeaderSaysOfTheDatum) {
    const std::string fix = "B0947004637500N00955250EA0123401300\n";
    EXPECT_EQ(flight_of("HFDTE120420\nHFALGALTGPS:GEO\n" + fix).gnss_datum, HeightDatum::msl_egm96);
    EXPECT_FALSE(flight_of("HFDTE120420\nHFALGALTGPS:NIL\n" + fix).fixes[0].gnss_height_m);
    EXPECT_FALSE(flight_of(kHead + "HFALPALTPRESSURE:MSL\n" + fix).fixes[0].pressure_altitude_m);
    EXPECT_THAT(import_igc("HFDTEDATE:120420,01\n" + fix, "t.igc").notes, Contains(HasSubstr("no HFALG")));
}

TEST(IgcImporter, ZerosThroughoutAreNoAltitude) {
    const RecordedFlight flight = flight_of(kHead + "B0947004637500N00955250EA0000001300\nB0947014637500N00955250EA0000001301\n");
    EXPECT_FALSE(flight.fixes[0].pressure_altitude_m);
    EXPECT_TRUE(flight.fixes[0].gnss_height_m);
}

TEST(IgcImporter, RefusesWhatIsNoFlight) {
    test_support::expect_user_error([] { (void)import_igc("AXXX\nHFDTE120420\n", "t.igc"); }, "no usable B record");
    test_support::expect_user_error([] { (void)import_igc("AXXX\nB0947004637500N00955250EA0123401300\n", "t.igc"); },
                                    "t.igc:2: a fix comes before the date");
    test_support::expect_user_error([] { (void)import_igc("AXXX\nHFDTE310220\n", "t.igc"); }, "t.igc:2: the date record");
}

}  // namespace
}  // namespace tedavis::host_sim::test_igc_importer
