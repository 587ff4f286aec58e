/// Rays against the triangles of a raster over the WGS84 ellipsoid, by marching: slow, and shares nothing with the display
/// but the definition of the surface. Places by GeographicLib.
#pragma once

#include <GeographicLib/Geocentric.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::test_support {

/// A pinhole camera as the display states it: pose of the own ship in degrees and metres, pixels from the top left corner.
struct OracleCamera {
    glm::dvec3 eye, forward, right, down;  ///< ECEF
    double focal_px, width, height;

    OracleCamera(double lat_deg, double lon_deg, double ellipsoid_m, double heading_deg, double pitch_deg, double roll_deg,
                 double field_of_view_deg, double width_px, double height_px)
        : focal_px(width_px / 2 / std::tan(base::radians(field_of_view_deg / 2))), width(width_px), height(height_px) {
        std::vector<double> east_north_up(9);
        GeographicLib::Geocentric::WGS84().Forward(lat_deg, lon_deg, ellipsoid_m, eye.x, eye.y, eye.z, east_north_up);
        const auto column = [&](int c) { return glm::dvec3(east_north_up[c], east_north_up[3 + c], east_north_up[6 + c]); };
        const glm::dvec3 east = column(0), north = column(1), up = column(2);
        const double h = base::radians(heading_deg), p = base::radians(pitch_deg), r = base::radians(roll_deg);
        const glm::dvec3 level = north * std::cos(h) + east * std::sin(h), level_right = east * std::cos(h) - north * std::sin(h);
        forward = level * std::cos(p) + up * std::sin(p);
        const glm::dvec3 level_down = level * std::sin(p) - up * std::cos(p);
        right = level_right * std::cos(r) + level_down * std::sin(r);
        down = level_down * std::cos(r) - level_right * std::sin(r);
    }
    [[nodiscard]] glm::dvec3 ray(double x, double y) const {
        return glm::normalize(forward * focal_px + right * (x - width / 2) + down * (y - height / 2));
    }
    /// Empty behind the eye.
    [[nodiscard]] std::optional<std::pair<double, double>> pixel(const glm::dvec3& point) const {
        const glm::dvec3 d = point - eye;
        const double depth = glm::dot(d, forward);
        if (depth <= 0) return std::nullopt;
        return std::make_pair(width / 2 + focal_px * glm::dot(d, right) / depth,
                              height / 2 + focal_px * glm::dot(d, down) / depth);
    }
};

class RasterRayCaster {
public:
    explicit RasterRayCaster(const host_sim::Raster& raster)
        : raster_(raster),
          highest_m_(double{*std::max_element(raster.height_m.begin(), raster.height_m.end())} + 100),
          cell_m_(std::min(raster.step_lat_deg, raster.step_lon_deg * std::cos(base::radians(raster.north_deg))) * 111'000) {}

    /// Height of the surface above the ellipsoid; empty outside the raster. Degrees.
    [[nodiscard]] std::optional<double> surface_m(double lat_deg, double lon_deg) const {
        const double x = (lon_deg - raster_.west_deg) / raster_.step_lon_deg,
                     y = (raster_.north_deg - lat_deg) / raster_.step_lat_deg;
        if (!(x >= 0 && y >= 0 && x < raster_.columns - 1 && y < raster_.rows - 1)) return std::nullopt;
        const auto i = static_cast<std::uint32_t>(x), j = static_cast<std::uint32_t>(y);
        const double u = x - i, v = y - j;
        const auto post = [&](std::uint32_t a, std::uint32_t b) { return double{raster_.height_m[raster_.at(a, b)]}; };
        const double height = u + v <= 1 ? post(i, j) + u * (post(i + 1, j) - post(i, j)) + v * (post(i, j + 1) - post(i, j))
                                         : post(i + 1, j + 1) + (1 - u) * (post(i, j + 1) - post(i + 1, j + 1)) +
                                               (1 - v) * (post(i + 1, j) - post(i + 1, j + 1));
        return height + geoid_.undulation(base::radians(lat_deg), base::radians(lon_deg)).m;
    }

    [[nodiscard]] bool hits(const glm::dvec3& eye, const glm::dvec3& ray, double reach_m = 150'000) const {
        double last_height = 1e9;
        for (double distance = 2; distance < reach_m; distance += std::clamp(0.004 * distance, 1.0, cell_m_ / 4)) {
            const glm::dvec3 p = eye + ray * distance;
            double lat = 0, lon = 0, height = 0;
            GeographicLib::Geocentric::WGS84().Reverse(p.x, p.y, p.z, lat, lon, height);
            if (height > highest_m_ && height > last_height) return false;
            last_height = height;
            const auto ground = surface_m(lat, lon);
            if (ground && height < *ground) return true;
        }
        return false;
    }

    /// The uppermost pixel centre of a column whose ray meets the surface; empty when none does.
    [[nodiscard]] std::optional<double> skyline_px(const OracleCamera& camera, int column) const {
        constexpr int kStride = 8;
        const auto hit = [&](int row) { return hits(camera.eye, camera.ray(column + 0.5, row + 0.5)); };
        int below = 0;
        while (below < camera.height && !hit(below)) below += kStride;
        if (below >= camera.height) return std::nullopt;
        int above = std::max(below - kStride, -1);
        while (below - above > 1) {
            const int middle = (below + above) / 2;
            (hit(middle) ? below : above) = middle;
        }
        return below;
    }

private:
    const host_sim::Raster& raster_;
    double highest_m_, cell_m_;
    host_sim::GeoidEgm96 geoid_ = host_sim::GeoidEgm96::installed();
};

}  // namespace tedavis::test_support
