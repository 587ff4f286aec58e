#include "host_sim/scene_builder/flight_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include <cstdio>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_flight_source {
namespace {

using test_support::expect_user_error;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr std::int64_t kStart_s = 1'586'684'820;

class FlightFiles : public ::testing::Test {
protected:
    SourceFeatures read(const std::string& text, const std::string& aircraft = "") {
        return read_flight_file(folder_.write("flight.txt", text), aircraft);
    }

    test_support::TemporaryFolder folder_;
};

/// A fix a second on a geodesic to the north-east at 50 m/s, climbing 2 m/s; `cells` of each second after the place.
std::string csv(
    const std::string& columns, int count, const std::function<std::string(int)>& cells,
    const std::function<int(int)>& second = [](int n) { return n; }) {
    std::string text = "time,latitude_deg,longitude_deg," + columns + "\n";
    for (int n = 0; n < count; ++n) {
        double latitude = 0, longitude = 0;
        GeographicLib::Geodesic::WGS84().Direct(46.8, 9.8, 45, 50 * second(n), latitude, longitude);
        char place[100];
        std::snprintf(place, sizeof place, "%.0f,%.9f,%.9f,", static_cast<double>(kStart_s + second(n)), latitude, longitude);
        text += place + cells(n) + "\n";
    }
    return text;
}

TEST_F(FlightFiles, PointsHaveTimeHeightAndDerivedSpeeds) {
    const SourceFeatures found = read(csv("height_msl_m", 60, [](int n) { return std::to_string(2000 + 2 * n); }));
    ASSERT_EQ(found.features.size(), 1u);
    EXPECT_EQ(found.height_datum, scene::HeightDatum::msl);
    const SourceFeature& line = found.features[0];
    EXPECT_EQ(line.shape, scene::LayerShape::lines);
    ASSERT_EQ(line.points.size(), 60u);
    EXPECT_EQ(line.points[7].time_ns, (kStart_s + 7) * 1'000'000'000);
    EXPECT_NEAR(*line.points[7].height_m, 2014, 0.01);
    for (const std::size_t n : {std::size_t{0}, std::size_t{30}, std::size_t{59}}) {
        EXPECT_NEAR(line.point_values.at("ground_speed")[n], 50, 0.1);
        EXPECT_NEAR(line.point_values.at("vertical_speed")[n], 2, 0.01);
        EXPECT_NEAR(base::degrees(line.point_values.at("track")[n]), 45, 0.5);
    }
    EXPECT_NEAR(std::stod(line.fields.at("last_time")), static_cast<double>(kStart_s + 59), 1e-3);
    EXPECT_NEAR(std::stod(line.fields.at("last_latitude_deg")), line.points[59].latitude_deg, 1e-12);
    EXPECT_NEAR(std::stod(line.fields.at("last_height")), 2118, 0.01);
    EXPECT_NEAR(std::stod(line.fields.at("last_ground_speed")), 50, 0.1);
    EXPECT_EQ(line.fields.at("is_latest"), "1");
    EXPECT_TRUE(found.notes.empty());
}

TEST_F(FlightFiles, FixesHoursApartAreNoLine) {
    const auto cells = [](int) { return std::string("2000"); };
    const SourceFeatures found = read(csv("height_msl_m", 2, cells, [](int n) { return 7200 * n; }));
    ASSERT_EQ(found.features.size(), 2u) << "each stands alone";
    for (const SourceFeature& feature : found.features) EXPECT_EQ(feature.points.size(), 1u);
    EXPECT_THAT(found.notes, Contains(HasSubstr("1 gap in the recording")));
    EXPECT_EQ(read(csv("height_msl_m", 2, cells, [](int n) { return 500 * n; })).features.size(), 1u);
}

TEST_F(FlightFiles, EllipsoidHeightsBecomeHeightsAboveTheSea) {
    const SourceFeatures found = read(csv("height_ellipsoid_m", 20, [](int) { return "2000"; }));
    const double undulation_m = GeoidEgm96::installed().undulation(base::radians(46.8), base::radians(9.8)).m;
    EXPECT_GT(undulation_m, 45);
    EXPECT_NEAR(*found.features[0].points[0].height_m, 2000 - undulation_m, 0.01);
}

TEST_F(FlightFiles, PressureAltitudesServeWhereThereIsNothingElse) {
    const SourceFeatures found = read(csv("pressure_altitude_m", 20, [](int) { return "1500"; }));
    EXPECT_NEAR(*found.features[0].points[3].height_m, 1500, 0.01);
    EXPECT_THAT(found.notes, Contains(HasSubstr("its pressure altitudes are taken for heights above sea level")));
    const SourceFeatures none = read(csv("track_deg", 20, [](int) { return "45"; }));
    EXPECT_FALSE(none.features[0].points[3].height_m);
    EXPECT_TRUE(std::isnan(none.features[0].point_values.at("vertical_speed")[3]));
    EXPECT_THAT(none.notes, Contains(HasSubstr("it has no heights and is shown on the ground")));
}

TEST_F(FlightFiles, MissingHeightsLieBetweenTheirNeighbours) {
    const SourceFeatures found =
        read(csv("height_msl_m", 120, [](int n) { return n < 5 || (n > 40 && n < 80) ? "" : std::to_string(2000 + 2 * n); }));
    const SourceFeature& line = found.features[0];
    EXPECT_NEAR(*line.points[60].height_m, 2120, 1);
    EXPECT_NEAR(*line.points[0].height_m, 2010, 1) << "the nearest one's before the first";
}

TEST_F(FlightFiles, GapsEndALine) {
    const SourceFeatures found = read(csv(
        "height_msl_m,aircraft", 40, [](int) { return "2000,HB-1234"; }, [](int n) { return n < 25 ? n : n + 600; }));
    ASSERT_EQ(found.features.size(), 2u);
    EXPECT_EQ(found.features[0].points.size(), 25u);
    EXPECT_EQ(found.features[1].points.size(), 15u);
    EXPECT_EQ(found.features[0].fields.at("is_latest"), "0");
    EXPECT_EQ(found.features[1].fields.at("is_latest"), "1");
    EXPECT_THAT(found.notes, Contains("HB-1234: 1 gap in the recording; nothing is shown there"));
}

TEST_F(FlightFiles, WhatWasNotFlownIsTakenOutAndCounted) {
    std::string text = csv("height_msl_m", 40, [](int) { return "2000"; });
    text += "1586684825,46.81,9.81,2000\n1586684870,-10,120,2000\n";  // an old time again, and another continent
    const SourceFeatures found = read(text);
    EXPECT_EQ(found.features[0].points.size(), 40u);
    EXPECT_THAT(found.notes, Contains("1 fixes were earlier than the one before and have been sorted"));
    EXPECT_THAT(found.notes, Contains("1 fixes had the time of another one and are left out"));
    EXPECT_THAT(found.notes, Contains("1 positions are impossible and are left out"));
}

TEST_F(FlightFiles, EachAircraftIsAFeatureAndOneMayBeChosen) {
    const auto cells = [](int n) { return std::string("2000,") + (n % 2 == 0 ? "4B1C22" : "4B088C"); };
    const std::string text = csv("height_msl_m,aircraft", 40, cells);
    const SourceFeatures both = read(text);
    ASSERT_EQ(both.features.size(), 2u);
    EXPECT_EQ(both.features[0].fields.at("name"), "4B1C22");
    EXPECT_EQ(both.features[1].fields.at("aircraft"), "4B088C");
    EXPECT_EQ(both.features[1].fields.at("is_latest"), "1");
    const SourceFeatures one = read(text, "4b088c");
    ASSERT_EQ(one.features.size(), 1u);
    EXPECT_EQ(one.features[0].fields.at("name"), "4B088C");
    expect_user_error([&] { (void)read(text, "D-ABCD"); },
                      "no aircraft 'D-ABCD'; it holds 4B1C22, 4B088C; name one in 'aircraft'");
}

TEST_F(FlightFiles, ASingleFixIsALineOfOnePoint) {
    const SourceFeatures found =
        read(R"([{"timestamp":1586684820000,"icao24":"4b1c22","callsign":"HBKRA","latitude":46.9,"longitude":7.5,)"
             R"("groundspeed":100,"track":90,"vertical_rate":600,"altitude":5000}])");
    ASSERT_EQ(found.features.size(), 1u);
    const SourceFeature& line = found.features[0];
    ASSERT_EQ(line.points.size(), 1u);
    EXPECT_EQ(line.fields.at("name"), "HBKRA");
    EXPECT_NEAR(*line.points[0].height_m, 1524, 1e-6);
    EXPECT_NEAR(line.point_values.at("ground_speed")[0], 51.444, 1e-3);
    EXPECT_NEAR(line.point_values.at("vertical_speed")[0], 3.048, 1e-9);
    EXPECT_NEAR(line.point_values.at("track")[0], base::radians(90), 1e-12);
}

TEST_F(FlightFiles, IgcAndGpxAreReadToo) {
    const SourceFeatures igc = read(
        "AXXX001\nHFDTE120420\nHFALGALTGPS:ELL\nB0947004648000N00948000EA0190002000\nB0947014648010N00948010EA0190002001\n"
        "B0947024648020N00948020EA0190002002\n");
    ASSERT_EQ(igc.features.size(), 1u);
    EXPECT_EQ(igc.features[0].points.size(), 3u);
    EXPECT_EQ(igc.features[0].points[0].time_ns, kStart_s * 1'000'000'000);
    const SourceFeatures gpx = read(
        "<gpx><trk><name>own</name><trkseg><trkpt lat='46.8' lon='9.8'><ele>2000</ele><time>2020-04-12T09:47:00Z</time></trkpt>"
        "<trkpt lat='46.8003' lon='9.8'><ele>2000</ele><time>2020-04-12T09:47:01Z</time></trkpt></trkseg></trk></gpx>");
    ASSERT_EQ(gpx.features.size(), 1u);
    EXPECT_EQ(gpx.features[0].fields.at("name"), "own");
    EXPECT_NEAR(*gpx.features[0].points[1].height_m, 2000, 1e-6);
}

TEST_F(FlightFiles, WhatIsNoFlightIsRefused) {
    expect_user_error([this] { (void)read(""); }, "the file is empty");
    expect_user_error([this] { (void)read("kind,lat,lon\nmast,46,9\n"); }, "flight.txt:1: the column");
    expect_user_error([] { (void)read_flight_file("/nowhere/x.igc", ""); }, "/nowhere/x.igc");
}

TEST(UsualAttributesOfFlights, AreTheValuesOfPoints) {
    const std::vector<AttributeRecipe> usual = usual_attributes_of_flights();
    ASSERT_EQ(usual.size(), 3u);
    EXPECT_EQ(usual[0].variable, "ground_speed");
    EXPECT_EQ(usual[2].unit, "rad");
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_source
