#include "host_sim/importers/adsb_json_importer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_adsb_json_importer {
namespace {

const std::string kRow =
    R"({"timestamp":1586684820000,"icao24":"4b1c22","callsign":"HBKRA","latitude":46.9,"longitude":7.5,)"
    R"("altitude":1000.0,"geoaltitude":1100.0,"groundspeed":100.0,"track":90.0,"vertical_rate":-600.0,"onground":false})";

TEST(AdsbJsonImporter, ReadsRecordsInTheirUnits) {
    const ImportedFile file = import_adsb_json("[" + kRow + "]", "t.json");
    ASSERT_EQ(file.flights.size(), 1u);
    EXPECT_EQ(file.flights[0].aircraft, "4b1c22");
    EXPECT_EQ(file.flights[0].callsign, "HBKRA");
    const RecordedFix& fix = file.flights[0].fixes.at(0);
    EXPECT_EQ(fix.time.ns, 1586684820 * std::int64_t{1'000'000'000});
    EXPECT_NEAR(fix.latitude_rad, 46.9 * base::kPi / 180, 1e-15);
    EXPECT_NEAR(*fix.pressure_altitude_m, 304.8, 1e-12);
    EXPECT_NEAR(*fix.gnss_height_m, 335.28, 1e-12);
    EXPECT_NEAR(*fix.ground_speed_mps, 51.44444444444444, 1e-12);
    EXPECT_NEAR(*fix.true_track_rad, base::kPi / 2, 1e-15);
    EXPECT_NEAR(*fix.vertical_speed_mps, -3.048, 1e-12);
    EXPECT_EQ(fix.on_ground, false);
    EXPECT_FALSE(fix.pitch_rad);
}

TEST(AdsbJsonImporter, TablesOfColumnsGiveTheSameFlight) {
    const ImportedFile columns = import_adsb_json(
        R"({"timestamp":{"5":1586684820000,"7":1586684821000},"latitude":{"5":46.9,"7":46.901},)"
        R"("longitude":{"5":7.5,"7":7.5},"altitude":{"5":1000.0,"7":null},"icao24":{"5":"4b1c22","7":"4b1c22"}})",
        "t.json");
    ASSERT_EQ(columns.flights.size(), 1u);
    ASSERT_EQ(columns.flights[0].fixes.size(), 2u);
    EXPECT_NEAR(*columns.flights[0].fixes[0].pressure_altitude_m, 304.8, 1e-12);
    EXPECT_FALSE(columns.flights[0].fixes[1].pressure_altitude_m);
}

TEST(AdsbJsonImporter, SeparatesAircraftAndSkipsRepeatedPositions) {
    const ImportedFile file =
        import_adsb_json(R"([{"timestamp":1000000,"last_position":999000,"icao24":"a","latitude":1,"longitude":2},)"
                         R"({"timestamp":1001000,"last_position":999000,"icao24":"a","latitude":1,"longitude":2},)"
                         R"({"timestamp":1002000,"last_position":1001500,"icao24":"a","latitude":1.1,"longitude":2},)"
                         R"({"timestamp":1000000,"icao24":"b","latitude":5,"longitude":6},{"timestamp":1,"icao24":"b"}])",
                         "t.json");
    ASSERT_EQ(file.flights.size(), 2u);
    ASSERT_EQ(file.flights[0].fixes.size(), 2u);
    EXPECT_EQ(file.flights[1].fixes.size(), 1u);
    EXPECT_THAT(file.notes, ::testing::ElementsAre("1 rows have no position and were skipped",
                                                   "1 rows repeat the position of the row before and were skipped"));
}

TEST(AdsbJsonImporter, TellsMillisecondsFromSeconds) {
    const auto time_of = [](const std::string& stamp) {
        return import_adsb_json(R"([{"timestamp":)" + stamp + R"(,"latitude":1,"longitude":2}])", "t.json")
            .flights.at(0)
            .fixes.at(0)
            .time.ns;
    };
    EXPECT_EQ(time_of("1586684820"), time_of("1586684820000"));
    EXPECT_EQ(time_of("6999999999"), time_of("6999999999000"));
    EXPECT_EQ(time_of("1586684820.25") - time_of("1586684820"), 250'000'000);
    const std::string beyond =
        R"([{"timestamp":8000000000000,"latitude":1,"longitude":2},{"timestamp":1,"latitude":1,"longitude":2}])";
    EXPECT_EQ(import_adsb_json(beyond, "t.json").flights.at(0).fixes.size(), 1u) << "neither seconds nor milliseconds";
    EXPECT_EQ(time_of("\"2020-04-12T09:47:00Z\""), time_of("1586684820000"));
}

TEST(AdsbJsonImporter, RefusesWhatCannotBeFlown) {
    test_support::expect_user_error([] { (void)import_adsb_json("[{\"a\":1},", "t.json"); }, "no valid JSON from byte");
    test_support::expect_user_error([] { (void)import_adsb_json("[{\"a\":1e999}]", "t.json"); },
                                    "t.json: holds a value that cannot be read");
    test_support::expect_user_error([] { (void)import_adsb_json("[1,2]", "t.json"); }, "entry 0 of the list is no record");
    test_support::expect_user_error([] { (void)import_adsb_json("{\"a\":1}", "t.json"); },
                                    "neither a list of records nor a table");
    test_support::expect_user_error([] { (void)import_adsb_json(R"({"timestamp":{"0":1,"1":2},"track":{"0":1}})", "t.json"); },
                                    "none of its 2 rows has a latitude");
    test_support::expect_user_error([] { (void)import_adsb_json(R"([{"timestamp":1,"latitude":95,"longitude":2}])", "t.json"); },
                                    "none of its 1 rows");
}

}  // namespace
}  // namespace tedavis::host_sim::test_adsb_json_importer
