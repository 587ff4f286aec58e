#include "host_sim/scene_builder/openair_source.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_openair_source {
namespace {

using test_support::expect_user_error;

constexpr double kNauticalMile_m = 1852;
constexpr const char* kHead = "AC D\nAN ZONE\nAL GND\nAH FL100\n";

SourceFeatures read(const std::string& text) { return read_openair(text, "zones.txt"); }

/// The outline of one airspace.
std::vector<SourcePoint> outline(const std::string& shape) {
    const SourceFeatures found = read(kHead + shape);
    EXPECT_EQ(found.features.size(), 1u) << shape;
    return found.features.empty() ? std::vector<SourcePoint>() : found.features[0].points;
}

/// On the ellipsoid, by another program.
struct Geodesic {
    double distance_m = 0, bearing_deg = 0;
};
Geodesic geodesic(double latitude_deg, double longitude_deg, const SourcePoint& to) {
    Geodesic found;
    double back_deg = 0;
    GeographicLib::Geodesic::WGS84().Inverse(latitude_deg, longitude_deg, to.latitude_deg, to.longitude_deg, found.distance_m,
                                             found.bearing_deg, back_deg);
    if (found.bearing_deg < 0) found.bearing_deg += 360;
    return found;
}

TEST(OpenAir, IsKnownByItsFirstCommand) {
    EXPECT_TRUE(is_openair("* by hand\r\n\r\nAC R\r\n"));
    EXPECT_TRUE(is_openair("ac D"));
    EXPECT_FALSE(is_openair(""));
    EXPECT_FALSE(is_openair("* nothing but words\n"));
    EXPECT_FALSE(is_openair("latitude,longitude\nAC R\n"));
}

TEST(OpenAir, PointsAndFields) {
    const SourceFeatures found = read(
        "* a comment\r\nAC R\r\nAY TMA\r\nAN  LS-R 1 Davos  * with a remark\r\nAL 4500ft MSL\r\nAH FL 130\r\n"
        "DP 46:47:30 N 009:49:15 E\r\nDP 46:50.5N 9:40.25E\r\nDP 46.75 N, 9.5 E\r\nDP 46:47:30 N 009:49:15 E\r\nSP "
        "0,1,0,0,255\r\n");
    ASSERT_EQ(found.features.size(), 1u);
    const SourceFeature& zone = found.features[0];
    EXPECT_EQ(zone.shape, scene::LayerShape::areas);
    EXPECT_EQ(zone.fields.at("class"), "R");
    EXPECT_EQ(zone.fields.at("type"), "TMA");
    EXPECT_EQ(zone.fields.at("name"), "LS-R 1 Davos");
    ASSERT_EQ(zone.points.size(), 3u) << "the first point again only closes it";
    EXPECT_NEAR(zone.points[0].latitude_deg, 46 + 47.5 / 60, 1e-12);
    EXPECT_NEAR(zone.points[0].longitude_deg, 9 + 49.25 / 60, 1e-12);
    EXPECT_NEAR(zone.points[1].latitude_deg, 46 + 50.5 / 60, 1e-12);
    EXPECT_NEAR(zone.points[1].longitude_deg, 9 + 40.25 / 60, 1e-12);
    EXPECT_NEAR(zone.points[2].longitude_deg, 9.5, 1e-12);
    const auto south_west = outline("DP 33:30:00S 070:15:00W\nDP 33:31:00S 070:15:00W\nDP 33:30:00S 070:14:00W\n");
    EXPECT_NEAR(south_west[0].latitude_deg, -33.5, 1e-12);
    EXPECT_NEAR(south_west[0].longitude_deg, -70.25, 1e-12);
}

TEST(OpenAir, LimitsAreMetresAboveWhatTheySay) {
    struct Case {
        const char* text;
        double height_m;
        const char* datum;
    };
    for (const Case& c : {Case{"FL145", 14500 * 0.3048, "standard"},
                          {"FL 95", 9500 * 0.3048, "standard"},
                          {"1500ft AMSL", 1500 * 0.3048, "msl"},
                          {"2500ft", 2500 * 0.3048, "msl"},
                          {"4500", 4500 * 0.3048, "msl"},
                          {"4500MSL", 4500 * 0.3048, "msl"},
                          {"300m AGL", 300, "ground"},
                          {"1000 ft agl", 304.8, "ground"},
                          {"2000M MSL", 2000, "msl"},
                          {"GND", 0, "ground"},
                          {"SFC", 0, "ground"},
                          {"UNL", 100000, "msl"},
                          {"UNLIM", 100000, "msl"}}) {
        const SourceFeatures found = read(std::string("AC D\nAN Z\nAL GND\nAH ") + c.text + "\nV X=46:00:00N 9:00:00E\nDC 2\n");
        ASSERT_EQ(found.features.size(), 1u) << c.text;
        EXPECT_NEAR(std::stod(found.features[0].fields.at("ceiling")), c.height_m, 1e-3) << c.text;
        EXPECT_EQ(found.features[0].fields.at("ceiling_datum"), c.datum) << c.text;
        EXPECT_EQ(found.features[0].fields.at("floor"), "0.000000");
        EXPECT_EQ(found.features[0].fields.at("floor_datum"), "ground");
    }
}

TEST(OpenAir, CirclesHaveTheirRadiusAnywhere) {
    for (const double latitude : {0.0, 46.5, -70.0}) {
        const std::string place = std::to_string(std::abs(latitude)) + (latitude < 0 ? "S" : "N");
        const auto points = outline("V X=" + place + " 179.9E\nDC 12.5\n");
        EXPECT_GE(points.size(), 30u);
        for (const SourcePoint& point : points)
            EXPECT_NEAR(geodesic(latitude, 179.9, point).distance_m, 12.5 * kNauticalMile_m, 0.01 * 12.5 * kNauticalMile_m);
    }
}

TEST(OpenAir, ChordsStayNearTheirArc) {
    const auto points = outline("V X=46:30:00N 009:30:00E\nDC 5\n");
    for (std::size_t n = 0; n < points.size(); ++n) {
        const SourcePoint &a = points[n], &b = points[(n + 1) % points.size()];
        const SourcePoint middle{(a.latitude_deg + b.latitude_deg) / 2, (a.longitude_deg + b.longitude_deg) / 2, {}, {}};
        EXPECT_GT(geodesic(46.5, 9.5, middle).distance_m, 0.985 * 5 * kNauticalMile_m);
    }
}

TEST(OpenAir, ArcsTurnTheWayTheyAreTold) {
    // From north to east: 90 degrees clockwise, 270 the other way.
    for (const bool is_clockwise : {true, false}) {
        const auto points = outline(std::string("V X=46:30:00N 009:30:00E\nV D=") + (is_clockwise ? "+" : "-") +
                                    "\nDA 5,0,90\nDP 46:30:00N 9:30:00E\n");
        ASSERT_GE(points.size(), 10u);
        EXPECT_NEAR(std::remainder(geodesic(46.5, 9.5, points.front()).bearing_deg, 360), 0, 0.5);
        EXPECT_NEAR(geodesic(46.5, 9.5, points[points.size() - 2]).bearing_deg, 90, 0.5);
        bool passes_south_west = false;
        for (std::size_t n = 0; n + 1 < points.size(); ++n) {
            const Geodesic at = geodesic(46.5, 9.5, points[n]);
            EXPECT_NEAR(at.distance_m, 5 * kNauticalMile_m, 0.01 * 5 * kNauticalMile_m);
            passes_south_west |= at.bearing_deg > 200 && at.bearing_deg < 250;
        }
        EXPECT_EQ(passes_south_west, !is_clockwise);
    }
    const auto whole = outline("V X=46:30:00N 009:30:00E\nDA 5,0,360\n");
    EXPECT_GE(whole.size(), 30u) << "a whole turn is a circle, not nothing";
}

TEST(OpenAir, ArcsBetweenTwoPlacesBeginAndEndThere) {
    const auto points =
        outline("V D=+\nV X=46:30:00N 009:30:00E\nDB 46:35:00N 009:30:00E, 46:30:00N 009:37:16E\nDP 46:30:00N 9:30:00E\n");
    ASSERT_GE(points.size(), 10u);
    EXPECT_NEAR(points[0].latitude_deg, 46 + 35.0 / 60, 1e-12);
    EXPECT_NEAR(points[0].longitude_deg, 9.5, 1e-12);
    const SourcePoint& last = points[points.size() - 2];
    EXPECT_NEAR(last.latitude_deg, 46.5, 1e-12);
    EXPECT_NEAR(last.longitude_deg, 9 + 37.0 / 60 + 16.0 / 3600, 1e-12);
    for (std::size_t n = 0; n + 1 < points.size(); ++n) {
        const Geodesic at = geodesic(46.5, 9.5, points[n]);
        EXPECT_NEAR(at.distance_m, 5 * kNauticalMile_m, 0.012 * 5 * kNauticalMile_m);
        EXPECT_LE(std::remainder(at.bearing_deg, 360), 91);
        EXPECT_GE(std::remainder(at.bearing_deg, 360), -1);
    }
}

TEST(OpenAir, BlocksFollowEachOther) {
    const SourceFeatures found = read(
        "AC C\nAN ONE\nAL GND\nAH UNL\nV D=-\nV X=46:00:00N 9:00:00E\nDC 3\n"
        "AC E\nAN named only\n"
        "AC D\nAN TWO\nAL 500ft AGL\nAH FL65\nDY 46:00:00N 9:00:00E\nDP 46:0:0N 9:0:0E\nDP 46:1:0N 9:0:0E\nDP 46:0:0N 9:1:0E\n");
    ASSERT_EQ(found.features.size(), 2u);
    EXPECT_EQ(found.features[0].fields.at("name"), "ONE");
    EXPECT_EQ(found.features[1].fields.at("name"), "TWO");
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_NE(found.notes[0].find("1 airway segments (DY) are not shown"), std::string::npos);
    expect_user_error([] { (void)read(std::string(kHead) + "V X=46:00:00N 9:00:00E\nDC 3\nAC D\nAL GND\nAH UNL\nDC 3\n"); },
                      "zones.txt:10: DC needs a centre");
}

TEST(OpenAir, FaultsAreSaidWithTheirLine) {
    const auto refused = [](const std::string& shape, const std::string& words) {
        expect_user_error([&shape] { (void)read(kHead + shape); }, words);
    };
    expect_user_error([] { (void)read("DP 46:00:00N 9:00:00E\n"); }, "zones.txt:1: stands before any AC");
    refused("DP somewhere\n", "zones.txt:5: 'somewhere' is no place; write for instance 46:47:30N 009:49:20E");
    refused("DP 95:00:00N 9:00:00E\n", "is no place");
    refused("DP 46:00:00N 190:00:00E\n", "is no place");
    refused("DP nanN 9E\n", "is no place");
    refused("DP 36:33:30N 84:99:30W\n", "zones.txt:5: '36:33:30N 84:99:30W' is no place");
    refused("DP 36:33:60N 84:09:30W\n", "is no place");
    refused("DP 36:60.0N 84:09.5W\n", "is no place");
    EXPECT_EQ(outline("V X=36:59:59.9N 84:59.99W\nDC 2\n").empty(), false);
    refused("DC 5\n", "zones.txt:5: DC needs a centre; write V X=... before it");
    refused("V X=46:00:00N 9:00:00E\nDC wide\n", "zones.txt:6: 'wide' is no radius");
    refused("V X=46:00:00N 9:00:00E\nDC -2\n", "is no radius");
    refused("V X=46:00:00N 9:00:00E\nDC 9000\n", "is no radius");
    refused("V X=46:00:00N 9:00:00E\nDA 5,20\n", "DA needs radius, first and last bearing");
    refused("V X=46:00:00N 9:00:00E\nDA -5,20,40\n", "DA needs radius, first and last bearing");
    refused("V X=46:00:00N 9:00:00E\nDB 46:05:00N 9:00:00E\n", "DB needs two places");
    refused("V elsewhere\n", "sets nothing; write V X=");
    refused("DP 46:00:00N 9:00:00E\nDP 46:01:00N 9:00:00E\n",
            "zones.txt:1: this airspace has 2 points; it needs three DP, or a DC");
    const std::string circle = "V X=46:00:00N 9:00:00E\nDC 5\n";
    expect_user_error([&circle] { (void)read("AC D\nAL GND\n" + circle); },
                      "zones.txt:1: this airspace has no ceiling; give it AH");
    expect_user_error([&circle] { (void)read("AC D\nAH UNL\n" + circle); }, "has no floor; give it AL");
    for (const char* const none : {"high", "nan", "inf", "FLinf", "10 furlongs", "500000ft"})
        expect_user_error([none] { (void)read(std::string("AC D\nAL ") + none + "\n"); }, "zones.txt:2: '");
    EXPECT_TRUE(read("").features.empty());
}

TEST(OpenAir, AFloorAboveItsCeilingIsRefused) {
    const auto zone = [](const std::string& limits) {
        return read("AC R\nAN Z\n" + limits + "V X=36:33:30N 084:16:30W\nDC 1.2\n").features.size();
    };
    expect_user_error([&] { (void)zone("AL 5000ft MSL\nAH 2600ft MSL\n"); },
                      "zones.txt:4: the floor of this airspace lies above its ceiling");
    expect_user_error([&] { (void)zone("AH FL65\nAL FL 95\n"); }, "zones.txt:4: the floor");
    expect_user_error([&] { (void)zone("AL 1000ft AGL\nAH 300ft AGL\n"); }, "above its ceiling");
    expect_user_error([&] { (void)zone("AL UNL\nAH 300m MSL\n"); }, "above its ceiling");
    for (const char* const sound : {"AL 2600ft MSL\nAH 5000ft MSL\n", "AL 2600ft\nAH 2600ft\n", "AL 1000ft AGL\nAH 700ft MSL\n"})
        EXPECT_EQ(zone(sound), 1u) << sound;
}

TEST(OpenAir, FloorAndCeilingAreItsUsualAttributes) {
    const SourceFeatures found = read(std::string(kHead) + "V X=46:00:00N 9:00:00E\nDC 2\n");
    std::vector<std::string> names;
    for (const AttributeRecipe& usual : usual_attributes_of_airspaces()) {
        EXPECT_EQ(found.features[0].fields.count(usual.variable), 1u) << usual.variable;
        names.push_back(usual.name);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"floor", "floor_datum", "ceiling", "ceiling_datum"}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_openair_source
