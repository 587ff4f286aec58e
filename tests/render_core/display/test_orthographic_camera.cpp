// The orthographic view's eye against a true parallel projection. Oracle of places: GeographicLib.
#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <algorithm>
#include <cmath>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/camera_views.hpp"

namespace tedavis::display::test_orthographic_camera {
namespace {

using base::radians;
using GeographicLib::Geocentric;
using test_support::ecef_of;
using Pixel = test_support::ViewPixel;
using Place = test_support::ViewPlace;
using test_support::own_ship_at;
using test_support::project;
using test_support::project_as_drawn;
constexpr const auto& kPlaces = test_support::kViewPlaces;

struct Oblique {
    double down_deg, turn_deg, range_m;
    std::uint32_t width, height;
};
constexpr Oblique kObliques[] = {{25, 0, 15'000, 640, 480}, {35, -70, 15'000, 640, 480}, {25, 140, 15'000, 480, 800},
                                 {60, 30, 2000, 800, 480},  {90, 0, 10'000, 640, 480},   {25, 200, 500, 640, 480}};

struct ObliqueCamera {
    ObliqueCamera(const Place& place, const Oblique& oblique, double msl_m = 2500)
        : input(own_ship_at(place.latitude_deg, place.longitude_deg)) {
        input.msl_m = msl_m;
        input.own_ship.height.m = msl_m;
        input.map_share = 1;
        input.map_up_rad = radians(17);
        input.width_px = oblique.width;
        input.height_px = oblique.height;
        design.mode = design::ViewMode::orthographic;
        design.map_range_m = oblique.range_m;
        design.look_down_rad = radians(oblique.down_deg);
        design.look_turn_rad = radians(oblique.turn_deg);
        camera = make_camera(input, design, 60'000);
        px_per_m = 0.5 * std::min(oblique.width, oblique.height) / oblique.range_m;
    }
    /// By depth from the own ship of a pixel's place at a height: from the ray, by halving.
    [[nodiscard]] glm::dvec3 at(double x, double y, double height_m) const {
        const terrain::View& view = camera.view;
        const glm::dvec3 ray = view.forward + view.right * ((x - 0.5 * view.width) / view.focal_px) +
                               view.down * ((y - 0.5 * view.height) / view.focal_px);
        const double middle = glm::dot(earth::to_ecef(input.own_ship) - view.eye, view.forward);
        double above = middle - 300'000, below = middle + 400'000;
        for (int n = 0; n < 80; ++n) {
            const double half = 0.5 * (above + below);
            const glm::dvec3 place = view.eye + ray * half;
            double latitude = 0, longitude = 0, height = 0;
            Geocentric::WGS84().Reverse(place.x, place.y, place.z, latitude, longitude, height);
            (height > height_m ? above : below) = half;
        }
        return view.eye + ray * below;
    }
    CameraInput input;
    design::ViewSettings design;
    Camera camera;
    double px_per_m = 0;
};

/// Against a true parallel projection: what is across the view, at the scale of the own ship.
double worst_length_error(const ObliqueCamera& oblique, const terrain::View& view) {
    double worst = 0;
    const glm::dvec3 axes[] = {view.right, view.down, view.forward};
    for (const double x : {0.0, 0.5, 1.0})
        for (const double y : {0.0, 0.5, 1.0})
            for (const double height_m : {-400.0, 4000.0, 9000.0}) {
                const glm::dvec3 place = oblique.at(x * view.width, y * view.height, height_m);
                const glm::dmat3 ned =
                    earth::north_east_down(oblique.input.own_ship.latitude_rad, oblique.input.own_ship.longitude_rad);
                for (int n = 0; n < 3; ++n) {
                    const glm::dvec3 length = ned[n] * (0.05 * oblique.design.map_range_m);
                    const Pixel a = project(view, place), b = project(view, place + length);
                    const double seen = std::hypot(b.x - a.x, b.y - a.y);
                    const double parallel = oblique.px_per_m * std::hypot(glm::dot(length, axes[0]), glm::dot(length, axes[1]));
                    if (parallel > 1) worst = std::max(worst, std::abs(seen / parallel - 1));
                }
            }
    return worst;
}

TEST(OrthographicCamera, InTheOrthographicViewEqualLengthsAreEquallyLong) {
    double worst = 0;
    for (const Place& place : kPlaces)
        for (const Oblique& setting : kObliques) {
            const ObliqueCamera oblique(place, setting);
            const double error = worst_length_error(oblique, oblique.camera.view);
            EXPECT_LT(error, 0.01) << place.latitude_deg << " " << setting.down_deg << " " << setting.range_m;
            worst = std::max(worst, error);
        }
    EXPECT_GT(worst, 0.003) << "the bound is no idle one";
    ObliqueCamera near(kPlaces[1], kObliques[1]);
    near.camera.view.eye += near.camera.view.forward * (0.97 * 15'000'000);
    near.camera.view.focal_px *= 0.03;
    EXPECT_GT(worst_length_error(near, near.camera.view), 0.02) << "control: an eye that is not so far";
}

TEST(OrthographicCamera, TheOrthographicViewLooksAtTheOwnShipAsAsked) {
    for (const Place& place : kPlaces)
        for (const Oblique& setting : kObliques) {
            const ObliqueCamera oblique(place, setting);
            const terrain::View& view = oblique.camera.view;
            const glm::dvec3 own_ship = ecef_of(place.latitude_deg, place.longitude_deg, 2500);
            for (const Pixel& middle : {project(view, own_ship), project_as_drawn(view, own_ship)}) {
                EXPECT_NEAR(middle.x, 0.5 * setting.width, 0.3);
                EXPECT_NEAR(middle.y, 0.5 * setting.height, 0.3);
            }
            const glm::dvec3 level = earth::body_axes(oblique.input.own_ship.latitude_rad, oblique.input.own_ship.longitude_rad,
                                                      radians(17 + setting.turn_deg), 0, 0)[0];
            const glm::dvec3 up =
                -earth::north_east_down(oblique.input.own_ship.latitude_rad, oblique.input.own_ship.longitude_rad)[2];
            EXPECT_NEAR(glm::dot(view.forward, up), -std::sin(radians(setting.down_deg)), 1e-9);
            EXPECT_NEAR(glm::dot(view.forward, level), std::cos(radians(setting.down_deg)), 1e-9);
            EXPECT_EQ(oblique.camera.haze_per_m, 0);
            EXPECT_EQ(oblique.camera.height_weight, 1);
        }
}

TEST(OrthographicCamera, PlanesOfTheOrthographicViewEncloseWhatItShows) {
    for (const Place& place : kPlaces)
        for (const Oblique& setting : kObliques)
            for (const double msl_m : {-300.0, 2500.0, 13'000.0}) {
                const ObliqueCamera oblique(place, setting, msl_m);
                const terrain::View& view = oblique.camera.view;
                ASSERT_GT(view.near_m, 0);
                for (const double x : {0.0, 0.5, 1.0})
                    for (const double y : {0.0, 0.5, 1.0})
                        for (const double height_m : {-600.0, 9000.0, 20'000.0}) {
                            const Pixel pixel = project(view, oblique.at(x * view.width, y * view.height, height_m));
                            EXPECT_GT(pixel.depth, view.near_m) << setting.down_deg << " " << height_m;
                            EXPECT_LT(pixel.depth, view.far_m) << setting.down_deg << " " << height_m;
                        }
                EXPECT_LT(view.far_m, 16'777'216) << "beyond, seams would open";
            }
}

}  // namespace
}  // namespace tedavis::display::test_orthographic_camera
