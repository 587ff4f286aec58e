/// Eyes over places of the Earth, and where they see things: GeographicLib's coordinates, and the vertex shader's arithmetic.
#pragma once

#include <GeographicLib/Geocentric.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render_core/base/units.hpp"
#include "render_core/display/planner/camera.hpp"

namespace tedavis::test_support {

inline constexpr double kViewGround_m = 400;  // of the terrain below the own ship, above MSL and the ellipsoid alike

inline display::CameraInput own_ship_at(double latitude_deg, double longitude_deg, double above_ground_m = 1500) {
    display::CameraInput input;
    input.msl_m = kViewGround_m + above_ground_m;
    input.own_ship = {base::radians(latitude_deg), base::radians(longitude_deg), {input.msl_m}};
    input.above_ground_m = above_ground_m;
    input.heading_rad = base::radians(40);
    input.pitch_rad = base::radians(-4);
    input.roll_rad = base::radians(12);
    input.width_px = 1024;
    input.height_px = 768;
    return input;
}

struct ViewPixel {
    double x = 0, y = 0, depth = 0;
};

inline ViewPixel project(const terrain::View& view, const glm::dvec3& ecef) {
    const glm::dvec3 from = ecef - view.eye;
    const double depth = glm::dot(from, view.forward);
    return {0.5 * view.width + view.focal_px * glm::dot(from, view.right) / depth,
            0.5 * view.height + view.focal_px * glm::dot(from, view.down) / depth, depth};
}

/// As a vertex goes through the shader: whole metres from the eye in float, then a matrix of floats.
inline ViewPixel project_as_drawn(const terrain::View& view, const glm::dvec3& ecef) {
    const glm::dvec3 eye_whole = glm::round(view.eye), fraction = view.eye - eye_whole;
    const glm::dvec3 chunk = glm::round(ecef / 4096.0) * 4096.0;
    const glm::vec3 relative = glm::vec3(chunk - eye_whole) + glm::vec3(ecef - chunk);
    float clip[3];
    const glm::dvec3 rows[3] = {view.right / view.half_width_tangent(), view.down / view.half_height_tangent(), view.forward};
    for (int n = 0; n < 3; ++n) {
        const glm::vec3 row(rows[n]);
        clip[n] = row.x * relative.x + row.y * relative.y + row.z * relative.z - static_cast<float>(glm::dot(rows[n], fraction));
    }
    return {0.5 * view.width * (1 + static_cast<double>(clip[0] / clip[2])),
            0.5 * view.height * (1 + static_cast<double>(clip[1] / clip[2])), static_cast<double>(clip[2])};
}

inline glm::dvec3 ecef_of(double latitude_deg, double longitude_deg, double height_m) {
    glm::dvec3 ecef;
    GeographicLib::Geocentric::WGS84().Forward(latitude_deg, longitude_deg, height_m, ecef.x, ecef.y, ecef.z);
    return ecef;
}

struct ViewPlace {
    double latitude_deg, longitude_deg;
};
inline constexpr ViewPlace kViewPlaces[] = {{0, 0},      {46.8, 9.9}, {-33.9, 179.9999}, {71, -180},
                                            {89.99, 45}, {90, 30},    {-90, -70}};

}  // namespace tedavis::test_support
