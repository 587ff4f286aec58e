/// Where a drawn mesh is farthest from the true surface. Both are flat between their own edges, so their difference is
/// extreme at posts, at the mesh's corners and where its edges cross the posts' rows, columns and diagonals: all of these are
/// looked at, and the worst of every part of the chunk are measured once more without any approximation.
#pragma once

#include <array>
#include <random>

#include "render_core/terrain/view.hpp"
#include "tests/support/terrain/gdal_terrain.hpp"
#include "tests/support/terrain/memory_terrain.hpp"

namespace tedavis::test_support {

/// A drawn point, and the true one of the same latitude and longitude.
struct DrawnPlace {
    glm::dvec3 drawn, truth;
    double error_m = 0;  ///< drawn above true
};

/// Places by GeographicLib; false where there is no true surface, which the terrain gives with surface_at(latitude, longitude).
template <class Terrain>
[[nodiscard]] bool make_drawn_place(const Terrain& terrain, const glm::dvec3& drawn, DrawnPlace& place) {
    double latitude_deg = 0, longitude_deg = 0, height_m = 0;
    GeographicLib::Geocentric::WGS84().Reverse(drawn.x, drawn.y, drawn.z, latitude_deg, longitude_deg, height_m);
    const double truth_m = terrain.surface_at(latitude_deg, longitude_deg);
    if (std::isnan(truth_m)) return false;
    place = {drawn, GdalTerrain::ecef(latitude_deg, longitude_deg, truth_m), height_m - truth_m};
    return true;
}

[[nodiscard]] inline bool is_in_picture(const terrain::View& view, const glm::dvec3& point) {
    const glm::dvec3 d = point - view.eye;
    const double depth = glm::dot(d, view.forward);
    return depth >= view.near_m && std::abs(glm::dot(d, view.right)) <= depth * view.half_width_tangent() &&
           std::abs(glm::dot(d, view.down)) <= depth * view.half_height_tangent();
}

/// Between the projections of the drawn and the true point; a true one before the near plane counts as on it.
[[nodiscard]] inline double displacement_px(const terrain::View& view, const DrawnPlace& place) {
    const glm::dvec3 d = place.drawn - view.eye, t = place.truth - view.eye;
    const double depth = glm::dot(d, view.forward), true_depth = std::max(glm::dot(t, view.forward), view.near_m);
    return view.focal_px * std::hypot(glm::dot(d, view.right) / depth - glm::dot(t, view.right) / true_depth,
                                      glm::dot(d, view.down) / depth - glm::dot(t, view.down) / true_depth);
}

/// Somewhere in one of the triangles; `up_m` says by how much a vertex is raised.
template <class UpM>
[[nodiscard]] glm::dvec3 random_point(const ChunkTriangles& mesh, std::mt19937& random, const UpM& up_m) {
    const std::size_t triangle = 3 * (random() % (mesh.indices.size() / 3));
    const auto unit = [&random] { return std::uniform_real_distribution<double>(0, 1)(random); };
    const double weights[3] = {unit(), unit(), unit()};
    const double sum = weights[0] + weights[1] + weights[2];
    glm::dvec3 point = mesh.centre;
    for (std::size_t k = 0; k < 3; ++k) {
        const terrain::ChunkVertex& v = mesh.vertices[mesh.indices[triangle + k]];
        point += (glm::dvec3(double{v.x}, double{v.y}, double{v.z}) + up_m(v)) * (weights[k] / sum);
    }
    return point;
}
[[nodiscard]] inline glm::dvec3 random_point(const ChunkTriangles& mesh, std::mt19937& random) {
    return random_point(mesh, random, [](const terrain::ChunkVertex&) { return glm::dvec3(0); });
}

class MeshPlaces {
public:
    explicit MeshPlaces(const GdalTerrain& terrain) : terrain_(terrain) {}

    [[nodiscard]] std::vector<DrawnPlace> worst(const ChunkTriangles& mesh) {
        bins_ = {};
        mesh_ = &mesh;
        for (std::size_t n = 0; n < mesh.indices.size(); n += 3) look_at(mesh.indices.data() + n);
        std::vector<DrawnPlace> places;
        for (const Bin& bin : bins_)
            for (const Extreme& extreme : bin) {
                DrawnPlace place;
                if (extreme.size_m >= 0 && make_drawn_place(terrain_, extreme.drawn, place)) places.push_back(place);
            }
        return places;
    }

private:
    static constexpr int kBins = 4, kOfEachSign = 3;  // a side; above and below
    struct Extreme {
        double size_m = -1;
        glm::dvec3 drawn;
    };
    using Bin = std::array<Extreme, 2 * kOfEachSign>;
    struct Corner {
        double i, j;
        glm::dvec3 place;
    };

    void look_at(const std::uint16_t* indices) {
        for (int k = 0; k < 3; ++k) {
            const terrain::ChunkVertex& v = mesh_->vertices[indices[k]];
            corner_[k] = {double(mesh_->posts.i0 + v.i), double(mesh_->posts.j0 + v.j),
                          mesh_->centre + glm::dvec3(double{v.x}, double{v.y}, double{v.z})};
        }
        for (int k = 0; k < 3; ++k) look_along(corner_[k], corner_[(k + 1) % 3]);
        look_at_posts();
        constexpr double kThird = 1.0 / 3;
        offer(kThird * (corner_[0].i + corner_[1].i + corner_[2].i), kThird * (corner_[0].j + corner_[1].j + corner_[2].j),
              kThird * (corner_[0].place + corner_[1].place + corner_[2].place));
    }
    void look_at_posts() {
        const Corner &a = corner_[0], &b = corner_[1], &c = corner_[2];
        const double area = (b.i - a.i) * (c.j - a.j) - (c.i - a.i) * (b.j - a.j);
        if (area == 0) return;
        for (double j = std::min({a.j, b.j, c.j}); j <= std::max({a.j, b.j, c.j}); ++j)
            for (double i = std::min({a.i, b.i, c.i}); i <= std::max({a.i, b.i, c.i}); ++i) {
                const double of_b = ((i - a.i) * (c.j - a.j) - (c.i - a.i) * (j - a.j)) / area,
                             of_c = ((b.i - a.i) * (j - a.j) - (i - a.i) * (b.j - a.j)) / area;
                if (of_b < 0 || of_c < 0 || of_b + of_c > 1) continue;
                offer(i, j, a.place + of_b * (b.place - a.place) + of_c * (c.place - a.place));
            }
    }
    /// Every edge is an edge of two triangles, or on the border: once is enough but at the border.
    void look_along(const Corner& a, const Corner& b) {
        if (a.j > b.j || (a.j == b.j && a.i > b.i)) return look_along(b, a);
        look_where(a, b, a.i, b.i);
        look_where(a, b, a.j, b.j);
        look_where(a, b, a.i + a.j, b.i + b.j);
    }
    /// Where a coordinate that goes from `from` to `to` is whole.
    void look_where(const Corner& a, const Corner& b, double from, double to) {
        if (from == to) return;
        const double step = from < to ? 1 : -1;
        for (double whole = from + step; (to - whole) * step > 0; whole += step) {
            const double t = (whole - from) / (to - from);
            offer(a.i + t * (b.i - a.i), a.j + t * (b.j - a.j), a.place + t * (b.place - a.place));
        }
    }
    void offer(double i, double j, const glm::dvec3& drawn) {
        const glm::dvec3 truth = terrain_.place_between(i, j);
        const double error_m = glm::dot(drawn - truth, truth) / glm::length(truth);
        if (std::isnan(error_m)) return;
        const terrain::PostRange& posts = mesh_->posts;
        const auto part = [](double at, double first, double last) {
            return static_cast<std::size_t>(std::clamp((at - first) / (last - first) * kBins, 0.0, kBins - 1.0));
        };
        Bin& bin = bins_[part(j, posts.j0, posts.j1) * kBins + part(i, posts.i0, posts.i1)];
        Extreme* const list = bin.data() + (error_m < 0 ? kOfEachSign : 0);
        const double size_m = std::abs(error_m);
        if (size_m <= list[kOfEachSign - 1].size_m) return;
        int n = kOfEachSign - 1;
        for (; n > 0 && list[n - 1].size_m < size_m; --n) list[n] = list[n - 1];
        list[n] = {size_m, drawn};
    }

    const GdalTerrain& terrain_;
    const ChunkTriangles* mesh_ = nullptr;
    Corner corner_[3];
    std::array<Bin, kBins * kBins> bins_;
};

}  // namespace tedavis::test_support
