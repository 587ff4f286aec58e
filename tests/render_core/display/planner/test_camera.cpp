// Oracle: GeographicLib's geodesics and geocentric coordinates, and the vertex shader's arithmetic in float.
#include "render_core/display/planner/camera.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/camera_views.hpp"

namespace tedavis::display::test_camera {
namespace {

using base::degrees;
using base::radians;
using GeographicLib::Geodesic;
using test_support::ecef_of;
using Pixel = test_support::ViewPixel;
using Place = test_support::ViewPlace;
using test_support::own_ship_at;
using test_support::project;
using test_support::project_as_drawn;
constexpr double kGround_m = test_support::kViewGround_m;
constexpr const auto& kPlaces = test_support::kViewPlaces;

design::ViewSettings map_of(double range_m) {
    design::ViewSettings view;
    view.mode = design::ViewMode::map;
    view.map_range_m = range_m;
    return view;
}

Camera map_camera(CameraInput input, double range_m, double up_deg = 0) {
    input.map_share = 1;
    input.map_up_rad = radians(up_deg);
    return make_camera(input, map_of(range_m), 60'000);
}

/// A place on the ground by azimuth and distance from the own ship.
glm::dvec3 ground_at(const CameraInput& input, double azimuth_deg, double distance_m, double height_m = kGround_m) {
    double latitude_deg = 0, longitude_deg = 0;
    Geodesic::WGS84().Direct(degrees(input.own_ship.latitude_rad), degrees(input.own_ship.longitude_rad), azimuth_deg, distance_m,
                             latitude_deg, longitude_deg);
    return ecef_of(latitude_deg, longitude_deg, height_m);
}

/// Places of the whole picture on the ground: straight up to the edges and into the corners.
template <class Visit>
void for_places_in_map(const CameraInput& input, double range_m, const Visit& visit) {
    const double px_per_m = map_scale_px_per_m(map_of(range_m), input.width_px, input.height_px);
    for (double azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += 15)
        for (const double share : {0.25, 0.7, 1.0}) {
            const double x = std::sin(radians(azimuth_deg)), y = std::cos(radians(azimuth_deg));
            const double to_edge_px = std::fmin(512 / std::fmax(std::abs(x), 1e-9), 384 / std::fmax(std::abs(y), 1e-9));
            visit(azimuth_deg, share * to_edge_px / px_per_m, share * to_edge_px);
        }
}

TEST(Camera, InThreeDItIsTheOwnShips) {
    CameraInput input = own_ship_at(46.8, 9.9);
    design::ViewSettings design;
    design.horizontal_field_of_view_rad = radians(50);
    design.eye_forward_m = 3;
    design.eye_down_m = -1.5;
    const Camera camera = make_camera(input, design, 60'000);
    const glm::dmat3 body = earth::body_axes(radians(46.8), radians(9.9), radians(40), radians(-4), radians(12));
    EXPECT_EQ(camera.view.forward, body[0]);
    EXPECT_EQ(camera.view.down, body[2]);
    EXPECT_LT(glm::length(camera.view.eye - (ecef_of(46.8, 9.9, 1900) + body[0] * 3.0 - body[2] * 1.5)), 1e-6);
    EXPECT_NEAR(camera.view.focal_px, 512 / std::tan(radians(25)), 1e-9);
    EXPECT_EQ(camera.haze_per_m, 1 / 60'000.0);
    EXPECT_EQ(camera.height_weight, 0);
    EXPECT_EQ(make_camera(input, design, 0).haze_per_m, 0);
    input.map_up_rad = 1;
    EXPECT_EQ(make_camera(input, design, 60'000).view.forward, body[0]) << "the map's direction is not its own";
}

TEST(Camera, TheAircraftsEyePointTurnsWithIt) {
    CameraInput input = own_ship_at(46.8, 9.9);
    const design::ViewSettings design;
    const terrain::View antenna = make_camera(input, design, 0).view;
    EXPECT_EQ(antenna.eye, earth::to_ecef(input.own_ship)) << "without an eye point it is the antenna, to the bit";
    input.eye_m = {4, -0.5, 1};
    const glm::dmat3 body = earth::body_axes(radians(46.8), radians(9.9), radians(40), radians(-4), radians(12));
    const terrain::View seat = make_camera(input, design, 0).view;
    EXPECT_LT(glm::length(seat.eye - antenna.eye - (body[0] * 4.0 - body[1] * 0.5 + body[2])), 1e-6);
    EXPECT_EQ(seat.forward, antenna.forward);
    EXPECT_EQ(seat.near_m, antenna.near_m);
    input.roll_rad = radians(90);
    const glm::dvec3 moved = make_camera(input, design, 0).view.eye - antenna.eye;
    const glm::dmat3 level = earth::body_axes(radians(46.8), radians(9.9), radians(40), radians(-4), 0);
    EXPECT_NEAR(glm::dot(moved, level[1]), -1, 1e-6) << "what is below the antenna is left of it in a bank to the right";
    EXPECT_NEAR(glm::dot(moved, level[2]), -0.5, 1e-6);
    design::ViewSettings with_own;
    with_own.eye_forward_m = 2;
    const glm::dvec3 both = make_camera(input, with_own, 0).view.eye - antenna.eye;
    EXPECT_NEAR(glm::dot(both - moved, body[0]), 2, 1e-6) << "the design's own is added";
    input.map_share = 1;
    const terrain::View map = make_camera(input, map_of(20'000), 0).view;
    input.eye_m = {0, 0, 0};
    EXPECT_LT(glm::length(map.eye - make_camera(input, map_of(20'000), 0).view.eye), 1e-6) << "the map's middle is the antenna";
}

TEST(Camera, OnTheMapPlacesLieAtTheirDistanceAndAzimuth) {
    for (const Place& place : kPlaces)
        for (const double range_m : {1000.0, 5000.0, 20'000.0, 60'000.0, 200'000.0})
            for (const double up_deg : {0.0, 137.0}) {
                const CameraInput input = own_ship_at(place.latitude_deg, place.longitude_deg);
                const terrain::View view = map_camera(input, range_m, up_deg).view;
                for_places_in_map(input, range_m, [&](double on_screen_deg, double distance_m, double expected_px) {
                    const glm::dvec3 ground = ground_at(input, on_screen_deg + up_deg, distance_m);
                    const double x = 512 + expected_px * std::sin(radians(on_screen_deg));
                    const double y = 384 - expected_px * std::cos(radians(on_screen_deg));
                    for (const Pixel& pixel : {project(view, ground), project_as_drawn(view, ground)}) {
                        EXPECT_NEAR(pixel.x, x, 0.7) << place.latitude_deg << " " << range_m << " " << on_screen_deg;
                        EXPECT_NEAR(pixel.y, y, 0.7) << place.latitude_deg << " " << range_m << " " << on_screen_deg;
                    }
                });
            }
}

TEST(Camera, TheMapWouldShowAnOwnShipThatIsNotBelowIt) {
    const CameraInput input = own_ship_at(46.8, 9.9), other = own_ship_at(46.8, 9.9004);
    const Pixel middle = project(map_camera(input, 5000).view, ecef_of(46.8, 9.9, 1900));
    EXPECT_NEAR(middle.x, 512, 1e-3);
    EXPECT_NEAR(middle.y, 384, 1e-3);
    EXPECT_GT(std::abs(project(map_camera(other, 5000).view, ecef_of(46.8, 9.9, 1900)).x - 512), 2) << "control";
}

TEST(Camera, SummitsAreHardlyDisplacedOnTheMap) {
    const CameraInput input = own_ship_at(46.8, 9.9);
    const auto displaced_px = [&](double range_m, double above_m) {
        const terrain::View view = map_camera(input, range_m).view;
        const Pixel foot = project(view, ground_at(input, 60, range_m)),
                    top = project(view, ground_at(input, 60, range_m, kGround_m + above_m));
        return std::hypot(top.x - foot.x, top.y - foot.y);
    };
    EXPECT_LT(displaced_px(1000, 1000), 0.5);
    EXPECT_LT(displaced_px(20'000, 4000), 2.0) << "the vertical leans with the Earth's curvature";
    EXPECT_LT(displaced_px(200'000, 4000), 0.4);
}

/// Seams rely on whole metres being exact in float, shading on depths that can be told.
TEST(Camera, TheMapsEyeIsNotTooFarForFloat) {
    for (const double range_m : {500.0, 15'000.0, 16'000.0, 500'000.0}) {
        const CameraInput input = own_ship_at(46.8, 9.9, 12'000);
        const terrain::View view = map_camera(input, range_m).view;
        EXPECT_LT(project(view, ground_at(input, 45, 1.4 * range_m)).depth, 16'777'216);
        EXPECT_GT(project(view, ground_at(input, 45, 0)).depth, 29 * range_m);
    }
}

TEST(Camera, PlanesEncloseTheGroundTightly) {
    for (const Place& place : kPlaces)
        for (const double range_m : {500.0, 20'000.0, 200'000.0, 500'000.0}) {
            const CameraInput input = own_ship_at(place.latitude_deg, place.longitude_deg);
            const terrain::View view = map_camera(input, range_m).view;
            for_places_in_map(input, range_m, [&](double azimuth_deg, double distance_m, double) {
                EXPECT_GT(project(view, ground_at(input, azimuth_deg, distance_m, 8900)).depth, view.near_m);
                EXPECT_LT(project(view, ground_at(input, azimuth_deg, distance_m, -530)).depth, view.far_m);
            });
            const double fallen_m = 0.5 * (1.7 * range_m) * (1.7 * range_m) / 6'350'000;
            EXPECT_LT(view.far_m - view.near_m, 10'000 + 1.2 * fallen_m);
        }
}

TEST(Camera, TheMapHasNoHazeAndTellsHeights) {
    const Camera camera = map_camera(own_ship_at(46.8, 9.9), 20'000);
    EXPECT_EQ(camera.haze_per_m, 0);
    EXPECT_EQ(camera.height_weight, 1);
}

std::vector<Camera> way(CameraInput input, const design::ViewSettings& design, int steps) {
    std::vector<Camera> cameras;
    for (int n = 0; n <= steps; ++n) {
        input.map_share = static_cast<double>(n) / steps;
        cameras.push_back(make_camera(input, design, 60'000));
    }
    return cameras;
}

/// As soon as the eye looks down, errors of height displace little and are told by colours alone.
TEST(Camera, HeightsCountAsTheEyeTurnsDown) {
    double before = 0;
    for (const Camera& camera : way(own_ship_at(46.8, 9.9), map_of(20'000), 50)) {
        EXPECT_GE(camera.height_weight, before);
        before = camera.height_weight;
    }
    EXPECT_EQ(before, 1);
}

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
    return degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

TEST(Camera, TheWayRisesStraightUpAndChangesTheScaleEvenly) {
    for (const double above_m : {2.0, 300.0, 12'000.0})
        for (const double range_m : {500.0, 20'000.0, 500'000.0}) {
            const CameraInput input = own_ship_at(46.8, 9.9, above_m);
            const glm::dmat3 local = earth::north_east_down(input.own_ship.latitude_rad, input.own_ship.longitude_rad);
            const glm::dvec3 own = earth::to_ecef(input.own_ship);
            double height_before = 0, scale_before = 0, haze_before = 1;
            int growing = 0, shrinking = 0;
            for (const Camera& camera : way(input, map_of(range_m), 200)) {
                const glm::dvec3 from = camera.view.eye - own;
                EXPECT_LT(std::hypot(glm::dot(from, local[0]), glm::dot(from, local[1])), 1e-9 * glm::length(from) + 1e-6);
                const double height = -glm::dot(from, local[2]), scale = camera.view.focal_px / (height + above_m);
                EXPECT_GE(height, height_before - 1e-6) << "never below the own ship, never down";
                if (scale_before > 0) ++(scale > scale_before ? growing : shrinking);
                EXPECT_LE(camera.haze_per_m, haze_before);
                height_before = height;
                scale_before = scale;
                haze_before = camera.haze_per_m;
            }
            // While it only turns the scale stands, but for rounding.
            EXPECT_LE(std::min(growing, shrinking), 71) << above_m << " " << range_m;
            EXPECT_GE(std::max(growing, shrinking), 129);
        }
}

TEST(Camera, TheWayHasNoJumpsAndTakesTheShorterTurn) {
    for (const double heading_deg : {10.0, 175.0, 350.0})
        for (const double up_deg : {0.0, 355.0, 190.0}) {
            CameraInput input = own_ship_at(46.8, 9.9);
            input.heading_rad = radians(heading_deg);
            input.roll_rad = radians(-35);
            input.map_up_rad = radians(up_deg);
            const std::vector<Camera> cameras = way(input, map_of(20'000), 240);
            double turned_deg = 0;
            for (std::size_t n = 1; n < cameras.size(); ++n) {
                const terrain::View &a = cameras[n - 1].view, &b = cameras[n].view;
                EXPECT_LT(angle_deg(a.forward, b.forward), 3.5);
                EXPECT_LT(angle_deg(a.right, b.right), 3.5);
                EXPECT_LT(std::abs(std::log(b.focal_px / a.focal_px)), 0.06);
                turned_deg += angle_deg(a.right, b.right);
            }
            const double between_deg = std::abs(degrees(earth::angle_difference(radians(up_deg), radians(heading_deg))));
            EXPECT_LT(turned_deg, between_deg + 60) << heading_deg << " to " << up_deg;
        }
}

TEST(Camera, BothEndsOfTheWayAreReachedSmoothly) {
    CameraInput input = own_ship_at(46.8, 9.9);
    design::ViewSettings design = map_of(20'000);
    design.eye_forward_m = 10;
    const auto at = [&](double share) {
        input.map_share = share;
        return make_camera(input, design, 60'000).view;
    };
    const glm::dvec3 ahead = ground_at(input, 40, 9000), below = ground_at(input, 40, 9000);
    const Pixel own = project(at(0), ahead), leaving = project(at(1e-5), ahead);
    EXPECT_LT(std::hypot(own.x - leaving.x, own.y - leaving.y), 1e-3);
    EXPECT_NEAR(at(0).near_m, at(1e-5).near_m, 1e-3);
    EXPECT_NEAR(at(0).far_m, at(1e-5).far_m, 1);
    const Pixel arriving = project(at(1 - 1e-5), below), arrived = project(at(1), below);
    EXPECT_LT(std::hypot(arrived.x - arriving.x, arrived.y - arriving.y), 1e-3);
}

/// The own ship's place comes into the picture before the eye has risen far, and stays.
TEST(Camera, TheGroundBelowTheOwnShipIsInViewOnceTheEyeRises) {
    const CameraInput input = own_ship_at(46.8, 9.9);
    const glm::dvec3 own = earth::to_ecef(input.own_ship);
    int in_view = 0;
    for (const Camera& camera : way(input, map_of(20'000), 100)) {
        if (glm::length(camera.view.eye - own) < 2000) continue;
        const Pixel pixel = project(camera.view, ground_at(input, 0, 0));
        EXPECT_GT(pixel.depth, 0);
        EXPECT_LT(std::abs(pixel.x - 512), 512);
        EXPECT_LT(std::abs(pixel.y - 384), 384);
        ++in_view;
    }
    EXPECT_GT(in_view, 40);
}

TEST(Camera, OnTheWayNoGroundIsCutOff) {
    int summits = 0, plains = 0;
    for (const double above_m : {2.0, 1500.0, 12'000.0}) {
        const CameraInput input = own_ship_at(46.8, 9.9, above_m);
        for (const Camera& camera : way(input, map_of(20'000), 60)) {
            const terrain::View& view = camera.view;
            EXPECT_GT(view.near_m, 0);
            EXPECT_GT(view.far_m, view.near_m);
            const double eye_height_m = glm::length(view.eye) - glm::length(ecef_of(46.8, 9.9, 0));
            for (double distance_m = 0; distance_m < 200'000; distance_m = 2 * distance_m + 500)
                for (double azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += 20)
                    for (const double height_m : {-400.0, 8900.0}) {
                        const Pixel pixel = project(view, ground_at(input, azimuth_deg, distance_m, height_m));
                        if (pixel.depth <= 0 || std::abs(pixel.x - 512) > 512 || std::abs(pixel.y - 384) > 384) continue;
                        EXPECT_LT(pixel.depth, view.far_m);
                        if (height_m > eye_height_m - 60) continue;  // the own ship would be in the mountain
                        EXPECT_GT(pixel.depth, view.near_m) << above_m << " " << distance_m << " " << height_m;
                        ++(height_m > 0 ? summits : plains);
                    }
        }
    }
    EXPECT_GT(summits, 1000);
    EXPECT_GT(plains, 1000);
}

TEST(Camera, ScaleIsOfTheShorterSide) {
    EXPECT_DOUBLE_EQ(map_scale_px_per_m(map_of(1000), 1024, 768), 0.384);
    EXPECT_DOUBLE_EQ(map_scale_px_per_m(map_of(1000), 480, 800), 0.24);
}

}  // namespace
}  // namespace tedavis::display::test_camera
