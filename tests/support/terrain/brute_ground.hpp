/// The ground of a raster, searched by brute force: every triangle of every cell is sampled. Slow, in double, and without any
/// code of the program but the undulation that a database states.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "host_sim/terrain_builder/raster.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::test_support {

class BruteGround {
public:
    BruteGround(const host_sim::Raster& raster, const terrain::TerrainDatabase& database) : raster_(raster) {
        for (std::uint32_t j = 0; j < raster.rows; ++j)
            for (std::uint32_t i = 0; i < raster.columns; ++i) {
                const double latitude = radians(latitude_deg(j)), longitude = radians(longitude_deg(i));
                const double height_m = static_cast<double>(raster.height_m[std::size_t{j} * raster.columns + i]);
                posts_.push_back(position(latitude, longitude, height_m + database.undulation(latitude, longitude).m));
            }
    }

    /// WGS84, from the ellipsoid's equation.
    [[nodiscard]] static glm::dvec3 position(double latitude_rad, double longitude_rad, double ellipsoid_m) {
        constexpr double kA = 6378137, kF = 1 / 298.257223563, kE2 = kF * (2 - kF);
        const double n = kA / std::sqrt(1 - kE2 * std::pow(std::sin(latitude_rad), 2));
        return {(n + ellipsoid_m) * std::cos(latitude_rad) * std::cos(longitude_rad),
                (n + ellipsoid_m) * std::cos(latitude_rad) * std::sin(longitude_rad),
                (n * (1 - kE2) + ellipsoid_m) * std::sin(latitude_rad)};
    }

    /// Metres above mean sea level, by the two triangles of a cell; NaN beside a void and outside.
    [[nodiscard]] double height_m(double latitude_rad, double longitude_rad) const {
        const double x = (longitude_rad * 180 / kHalfTurn - raster_.west_deg) / raster_.step_lon_deg,
                     y = (raster_.north_deg - latitude_rad * 180 / kHalfTurn) / raster_.step_lat_deg;
        if (!(x >= 0 && y >= 0 && x < raster_.columns - 1 && y < raster_.rows - 1))
            return std::numeric_limits<double>::quiet_NaN();
        const auto i = static_cast<std::uint32_t>(x), j = static_cast<std::uint32_t>(y);
        const double u = x - i, v = y - j, nw = post_m(i, j), ne = post_m(i + 1, j), sw = post_m(i, j + 1),
                     se = post_m(i + 1, j + 1);
        if (std::isnan(nw + ne + sw + se)) return std::numeric_limits<double>::quiet_NaN();
        return u + v < 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
    }

    /// From a place (ECEF, m) to the nearest sample of the ground that `counts`; infinite where there is none.
    template <class Counts>
    [[nodiscard]] double distance_m(const glm::dvec3& from, const Counts& counts) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t j = 0; j < raster_.rows; ++j)
            for (std::uint32_t i = 0; i < raster_.columns; ++i)
                if (!std::isnan(post_m(i, j)) && counts(post(i, j) - from))
                    least = std::min(least, glm::distance(from, post(i, j)));
        for (std::uint32_t j = 0; j + 1 < raster_.rows; ++j)
            for (std::uint32_t i = 0; i + 1 < raster_.columns; ++i) {
                const std::array<glm::dvec3, 4> corner{post(i, j), post(i + 1, j), post(i, j + 1), post(i + 1, j + 1)};
                if (std::isnan(post_m(i, j) + post_m(i + 1, j) + post_m(i, j + 1) + post_m(i + 1, j + 1))) continue;
                const double size = glm::distance(corner[0], corner[3]) + glm::distance(corner[1], corner[2]);
                if (glm::distance(from, corner[0]) > least + size) continue;
                for (const std::size_t apex : {std::size_t{0}, std::size_t{3}})
                    sample(from, corner[apex], corner[2], corner[1], counts, least);
            }
        return least;
    }
    [[nodiscard]] double distance_m(const glm::dvec3& from) const {
        return distance_m(from, [](const glm::dvec3&) { return true; });
    }

private:
    static constexpr double kHalfTurn = 3.14159265358979323846;
    static double radians(double degrees) { return degrees * kHalfTurn / 180; }
    [[nodiscard]] double latitude_deg(std::uint32_t j) const { return raster_.north_deg - j * raster_.step_lat_deg; }
    [[nodiscard]] double longitude_deg(std::uint32_t i) const { return raster_.west_deg + i * raster_.step_lon_deg; }
    [[nodiscard]] double post_m(std::uint32_t i, std::uint32_t j) const {
        return static_cast<double>(raster_.height_m[std::size_t{j} * raster_.columns + i]);
    }
    [[nodiscard]] const glm::dvec3& post(std::uint32_t i, std::uint32_t j) const {
        return posts_[std::size_t{j} * raster_.columns + i];
    }
    template <class Counts>
    static void sample(const glm::dvec3& from, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                       const Counts& counts, double& least) {
        constexpr int kSteps = 16;
        for (int n = 0; n <= kSteps; ++n)
            for (int m = 0; n + m <= kSteps; ++m) {
                const glm::dvec3 way = a + (b - a) * (n / double{kSteps}) + (c - a) * (m / double{kSteps}) - from;
                const double length = glm::length(way);
                if (length < least && counts(way)) least = length;
            }
    }

    const host_sim::Raster& raster_;
    std::vector<glm::dvec3> posts_;
};

}  // namespace tedavis::test_support
