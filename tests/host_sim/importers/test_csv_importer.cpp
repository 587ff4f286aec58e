#include "host_sim/importers/csv_importer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_csv_importer {
namespace {

TEST(CsvImporter, ReadsEveryDocumentedColumn) {
    const ImportedFile file = import_csv(
        "# a comment\n"
        "longitude_deg,time,latitude_deg,height_msl_m,pressure_altitude_m,ground_speed_mps,track_deg,vertical_speed_mps,pitch_"
        "deg,roll_deg,heading_deg,on_ground,aircraft\r\n"
        "9.5,1586684820.25,46.5,1500,1480,60,90,-2,3,-10,95,0,A\r\n"
        "\n9.6,2020-04-12T09:47:01Z,46.6,,,,,,,,,1,B\n",
        "t.csv");
    ASSERT_EQ(file.flights.size(), 2u);
    const RecordedFix& fix = file.flights[0].fixes.at(0);
    EXPECT_EQ(fix.time.ns, 1586684820'250'000'000);
    EXPECT_NEAR(base::degrees(fix.latitude_rad), 46.5, 1e-12);
    EXPECT_NEAR(base::degrees(fix.longitude_rad), 9.5, 1e-12);
    EXPECT_EQ(fix.gnss_height_m, 1500.0);
    EXPECT_EQ(fix.pressure_altitude_m, 1480.0);
    EXPECT_EQ(fix.ground_speed_mps, 60.0);
    EXPECT_NEAR(*fix.true_track_rad, base::kPi / 2, 1e-15);
    EXPECT_EQ(fix.vertical_speed_mps, -2.0);
    EXPECT_NEAR(base::degrees(*fix.pitch_rad), 3, 1e-12);
    EXPECT_NEAR(base::degrees(*fix.roll_rad), -10, 1e-12);
    EXPECT_NEAR(base::degrees(*fix.true_heading_rad), 95, 1e-12);
    EXPECT_EQ(fix.on_ground, false);
    EXPECT_EQ(file.flights[0].gnss_datum, HeightDatum::msl_egm96);
    EXPECT_EQ(file.flights[1].aircraft, "B");
    EXPECT_FALSE(file.flights[1].fixes[0].gnss_height_m);
    EXPECT_EQ(file.flights[1].fixes[0].on_ground, true);
}

TEST(CsvImporter, NamesIgnoredColumns) {
    const ImportedFile file = import_csv("time,latitude_deg,longitude_deg,fuel\n0,1,2,3\n", "t.csv");
    EXPECT_THAT(file.notes, ::testing::ElementsAre(::testing::HasSubstr("ignored: fuel")));
}

TEST(CsvImporter, NamesTheLineOfAFault) {
    const std::string head = "time,latitude_deg,longitude_deg,height_ellipsoid_m\n0,1,2,3\n";
    const auto refused = [&](const std::string& text, const std::string& words) {
        test_support::expect_user_error([&] { (void)import_csv(text, "t.csv"); }, words);
    };
    refused(head + "1,2\n", "t.csv:3: 2 cells, but the first line names 4 columns");
    refused(head + "1,north,2,3\n", "t.csv:3: 'north' is no number for latitude_deg");
    refused(head + "1,91,2,3\n", "t.csv:3: '91' is out of range");
    refused(head + "1,1,2,200000\n", "t.csv:3: '200000' is out of range for height_ellipsoid_m");
    refused(head + "1,1,2,nan\n", "t.csv:3: 'nan' is no number");
    refused(head + "1,,2,3\n", "'' is no number for latitude_deg");
    refused(head + "soon,1,2,3\n", "'soon' is no time");
    refused("time,latitude_deg\n", "t.csv:1: the column `longitude_deg` is missing");
    refused("time,time,latitude_deg,longitude_deg\n", "stands twice");
    refused("time,latitude_deg,longitude_deg,height_msl_m,height_ellipsoid_m\n", "keep the one that was measured");
    refused("time,latitude_deg,longitude_deg\n", "no row with a fix");
    refused("just words\n", "t.csv:1: the column");
}

}  // namespace
}  // namespace tedavis::host_sim::test_csv_importer
