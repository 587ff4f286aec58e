#include "host_sim/geoid_egm96.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/input_file.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_geoid_egm96 {
namespace {

const GeoidEgm96& grid() {
    static const GeoidEgm96 installed = GeoidEgm96::installed();
    return installed;
}

double at(double latitude_deg, double longitude_deg) {
    return grid().undulation(base::radians(latitude_deg), base::radians(longitude_deg)).m;
}

// Test points that the EGM96 authors publish with their synthesis program (OUTPUT.DAT), computed from the full spherical
// harmonics; a bilinear 15-minute grid is within half a metre there.
TEST(GeoidEgm96, AgreesWithThePublishedTestPoints) {
    struct Point {
        double latitude_deg, longitude_deg, undulation_m;
    };
    for (const Point& point :
         {Point{38.628155, 269.779155, -31.628}, Point{-14.621217, 305.021114, -2.969}, Point{46.874319, 102.448729, -43.575},
          Point{-23.617446, 133.874712, 15.871}, Point{38.625473, 359.9995, 50.066}, Point{-0.466744, 0.0023, 17.329}}) {
        EXPECT_NEAR(at(point.latitude_deg, point.longitude_deg), point.undulation_m, 0.5)
            << point.latitude_deg << " " << point.longitude_deg;
    }
}

TEST(GeoidEgm96, IsContinuousAcrossTheAntimeridianAndOneValueAtAPole) {
    for (double latitude = -89; latitude <= 89; latitude += 7)
        EXPECT_NEAR(at(latitude, 180 - 1e-9), at(latitude, -180 + 1e-9), 1e-6) << latitude;
    for (double longitude = -180; longitude < 180; longitude += 30) {
        EXPECT_NEAR(at(90, longitude), at(90, 0), 1e-3);
        EXPECT_NEAR(at(-90, longitude), at(-90, 0), 1e-3);
    }
}

TEST(GeoidEgm96, StaysWithinItsNeighbours) {
    const double south_west = at(46.5, 9.5), south_east = at(46.5, 9.75), north_west = at(46.75, 9.5),
                 north_east = at(46.75, 9.75);
    EXPECT_NEAR(at(46.625, 9.625), (south_west + south_east + north_west + north_east) / 4, 1e-5);
}

TEST(GeoidEgm96, RefusesWhatIsNoGrid) {
    const test_support::TemporaryFolder folder;
    test_support::expect_user_error([&] { GeoidEgm96(folder.write("short", "GTX")); }, "too short");
    test_support::expect_user_error([&] { GeoidEgm96(folder.write("noise", std::string(5000, 'x'))); },
                                    "not a global geoid grid");
    const std::string whole = read_file("/usr/share/proj/egm96_15.gtx");
    test_support::expect_user_error([&] { GeoidEgm96(folder.write("cut", whole.substr(0, whole.size() / 2))); },
                                    "does not fit its header");
}

}  // namespace
}  // namespace tedavis::host_sim::test_geoid_egm96
