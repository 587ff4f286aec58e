#include "host_sim/window/camera_tour.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_camera_tour {
namespace {

using base::degrees;
using test_support::expect_user_error;

const std::string kHeader = "time_s,latitude_deg,longitude_deg,altitude_m,heading_deg,pitch_deg,roll_deg\n";

CameraTour tour_of(const std::string& text) {
    return CameraTour(text, "path.csv", [](double, double) { return earth::GeoidUndulation{40}; });
}

TEST(CameraTour, PassesThroughItsPoints) {
    const CameraTour tour =
        tour_of("# a comment\n\n" + kHeader + "1.5,36.5,-84.25,1500,90,-10,5\r\n20, 36.6, -84.2, 1200, 60, -5, 0\n");
    const CameraPose first = tour.at(1.5), last = tour.at(20);
    EXPECT_NEAR(degrees(first.position.latitude_rad), 36.5, 1e-12);
    EXPECT_NEAR(degrees(first.position.longitude_rad), -84.25, 1e-12);
    EXPECT_NEAR(first.position.height.m, 1540, 1e-9) << "above the ellipsoid";
    EXPECT_NEAR(degrees(first.heading_rad), 90, 1e-12);
    EXPECT_NEAR(degrees(first.pitch_rad), -10, 1e-12);
    EXPECT_NEAR(degrees(first.roll_rad), 5, 1e-12);
    EXPECT_NEAR(degrees(last.heading_rad), 60, 1e-12);
}

TEST(CameraTour, RestsBeforeAndAfter) {
    const CameraTour tour = tour_of(kHeader + "10,1,2,100,0,0,0\n20,2,2,100,0,0,0\n");
    EXPECT_EQ(tour.at(0).position.latitude_rad, tour.at(10).position.latitude_rad);
    EXPECT_EQ(tour.at(1e6).position.latitude_rad, tour.at(20).position.latitude_rad);
    const CameraPose alone = tour_of(kHeader + "10,1,2,100,30,0,0").at(3);
    EXPECT_NEAR(degrees(alone.heading_rad), 30, 1e-12);
}

TEST(CameraTour, TakesTheShorterWay) {
    const CameraTour tour = tour_of(kHeader + "0,0,179,100,350,0,170\n10,0,-179,100,10,0,-170\n20,0,-178,100,350,0,170\n");
    EXPECT_NEAR(std::abs(degrees(tour.at(5).position.longitude_rad)), 180, 0.2);
    const double heading = degrees(tour.at(5).heading_rad);
    EXPECT_TRUE(heading > 355 || heading < 5) << heading;
    EXPECT_NEAR(std::abs(degrees(earth::angle_difference(tour.at(5).roll_rad, base::radians(180)))), 0, 3);
    for (double t = 0; t <= 20; t += 0.1) EXPECT_GT(std::abs(degrees(tour.at(t).position.longitude_rad)), 177.9) << t;
}

TEST(CameraTour, StaysBetweenItsPoints) {
    const CameraTour tour =
        tour_of(kHeader + "0,0,0,1000,0,0,0\n1,0,0,1000,0,0,0\n2,0,0,50,0,0,0\n9,0,0,50,0,0,0\n10,0,0,900,0,0,0\n");
    for (double t = 0; t <= 10; t += 0.05) {
        EXPECT_GE(tour.at(t).position.height.m, 90 - 1e-9) << t;
        EXPECT_LE(tour.at(t).position.height.m, 1040 + 1e-9) << t;
    }
    EXPECT_NEAR(tour.at(5).position.height.m, 90, 1e-9) << "no dip into the ground between equal heights";
}

TEST(CameraTour, SaysWhatIsWrongAndWhere) {
    const auto refused = [](const std::string& text, const std::string& words) {
        expect_user_error([&] { tour_of(text); }, words);
    };
    refused("", "path.csv:0: no point is in the tour; write the line");
    refused(kHeader, "path.csv:1: no point is in the tour; write");
    refused("# only\n# comments\n", "path.csv:2: no point is in the tour; write");
    refused("0,1,2,3,4,5,6\n", "path.csv:1: the first line does not name the columns; write");
    refused(kHeader + "0,1,2,3,4,5\n", "path.csv:2: not 7 values");
    refused(kHeader + "0,1,2,3,4,5,6,7\n", "path.csv:2: not 7 values");
    refused(kHeader + "0,1,2,high,4,5,6\n", "path.csv:2: altitude_m 'high' is not a number from -1000 to 100000");
    refused(kHeader + "0,91,2,3,4,5,6\n", "path.csv:2: latitude_deg '91' is not a number from -90 to 90");
    refused(kHeader + "0,nan,2,3,4,5,6\n", "latitude_deg 'nan'");
    refused(kHeader + "0,1,inf,3,4,5,6\n", "longitude_deg 'inf'");
    refused(kHeader + "0,,2,3,4,5,6\n", "latitude_deg ''");
    refused(kHeader + "\n0,1,2,3,4,5,6\n0,1,2,3,4,5,6\n", "path.csv:4: time_s does not rise");
    refused(std::string("\x89PNG\r\n\x1a\n", 8), "path.csv:1: the first line does not name");
}

}  // namespace
}  // namespace tedavis::host_sim::test_camera_tour
