/// How far drawn terrain is from the true one on the screen, measured from the vertices as submitted: an oracle that shares
/// nothing with the selection but the definition of the error. Places by GeographicLib.
#pragma once

#include <GeographicLib/Geocentric.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/drawn_terrain.hpp"
#include "tests/support/raster_ray_caster.hpp"

namespace tedavis::test_support {

struct ProbedError {
    double worst_px = 0;       ///< of drawn points in the picture
    double worst_below_m = 0;  ///< true minus drawn height, where that is positive
    std::uint64_t points = 0;
};

class PixelErrorProbe {
public:
    explicit PixelErrorProbe(const host_sim::Raster& raster) : truth_(raster) {}

    /// `points` drawn points of the selection, spread over its chunks and there over its triangles at random.
    ProbedError probe(DrawnTerrain& drawn, const terrain::View& view, int points, std::mt19937& random) const {
        ProbedError error;
        const auto selected = drawn.selected();
        if (selected.empty()) return error;
        const int of_chunk = std::max(1, points / static_cast<int>(selected.size()));
        for (const terrain::SelectedChunk& chunk : selected) {
            const std::vector<std::uint16_t>& indices = drawn.indices(chunk);
            for (int n = 0; n < of_chunk && !indices.empty(); ++n) {
                const std::size_t triangle = 3 * (random() % (indices.size() / 3));
                include(chunk, drawn.vertices(chunk), indices.data() + triangle, view, random, error);
            }
        }
        return error;
    }

private:
    void include(const terrain::SelectedChunk& chunk, base::Span<const terrain::ChunkVertex> vertices,
                 const std::uint16_t* corners, const terrain::View& view, std::mt19937& random, ProbedError& error) const {
        double weights[3];
        for (double& weight : weights) weight = std::uniform_real_distribution<double>(0, 1)(random);
        const double sum = weights[0] + weights[1] + weights[2];
        glm::dvec3 point(chunk.entry->centre_m[0], chunk.entry->centre_m[1], chunk.entry->centre_m[2]);
        for (int k = 0; k < 3; ++k) {
            const terrain::ChunkVertex& v = vertices[corners[k]];
            point += glm::dvec3(v.x, v.y, v.z) * (weights[k] / sum);
        }
        if (!in_picture(view, point)) return;
        double lat_deg = 0, lon_deg = 0, height_m = 0;
        const GeographicLib::Geocentric& earth = GeographicLib::Geocentric::WGS84();
        earth.Reverse(point.x, point.y, point.z, lat_deg, lon_deg, height_m);
        const auto truth_m = truth_.surface_m(lat_deg, lon_deg);
        if (!truth_m || std::isnan(*truth_m)) return;
        glm::dvec3 truth;
        earth.Forward(lat_deg, lon_deg, *truth_m, truth.x, truth.y, truth.z);
        ++error.points;
        error.worst_below_m = std::max(error.worst_below_m, *truth_m - height_m);
        error.worst_px = std::max(error.worst_px, distance_px(view, point, truth));
    }
    static bool in_picture(const terrain::View& view, const glm::dvec3& point) {
        const glm::dvec3 d = point - view.eye;
        const double depth = glm::dot(d, view.forward);
        return depth >= view.near_m && std::abs(glm::dot(d, view.right)) <= depth * view.half_width_tangent() &&
               std::abs(glm::dot(d, view.down)) <= depth * view.half_height_tangent();
    }
    static double distance_px(const terrain::View& view, const glm::dvec3& a, const glm::dvec3& b) {
        const glm::dvec3 da = a - view.eye, db = b - view.eye;
        const double za = glm::dot(da, view.forward), zb = std::max(glm::dot(db, view.forward), view.near_m);
        return view.focal_px * std::hypot(glm::dot(da, view.right) / za - glm::dot(db, view.right) / zb,
                                          glm::dot(da, view.down) / za - glm::dot(db, view.down) / zb);
    }

    RasterRayCaster truth_;
};

}  // namespace tedavis::test_support
