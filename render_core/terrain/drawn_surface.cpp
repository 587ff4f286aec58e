#include "render_core/terrain/drawn_surface.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::terrain {
namespace {

/// Lattice points are rounded; a point on a side must not fall between two triangles.
constexpr double kInside = -1e-6;

struct Weights {
    double at[3] = {0, 0, 0};

    [[nodiscard]] double least() const { return std::fmin(at[0], std::fmin(at[1], at[2])); }
};

struct Corner {
    double i, j;
    bool is_pole;
};

struct Triangle {
    Corner corner[3];
};

constexpr Weights kOutside{{-1, -1, -1}};

Weights plain_weights(const Triangle& t, double i, double j) {
    const Corner &a = t.corner[0], &b = t.corner[1], &c = t.corner[2];
    const auto doubled_area = [](double bi, double bj, double ci, double cj) { return ci * bj - bi * cj; };
    const double area = doubled_area(b.i - a.i, b.j - a.j, c.i - a.i, c.j - a.j);
    if (area == 0) return kOutside;
    Weights weights;
    weights.at[1] = doubled_area(i - a.i, j - a.j, c.i - a.i, c.j - a.j) / area;
    weights.at[2] = doubled_area(b.i - a.i, b.j - a.j, i - a.i, j - a.j) / area;
    weights.at[0] = 1 - weights.at[1] - weights.at[2];
    return weights;
}

/// Its apex is the pole, on every meridian: the point's meridian meets the base, and the point divides the way to there.
Weights polar_weights(const Triangle& t, std::uint32_t apex, double i, double j) {
    const std::uint32_t first = (apex + 1) % 3, second = (apex + 2) % 3;
    const Corner &a = t.corner[first], &b = t.corner[second];
    if (a.i == b.i) return kOutside;
    const double along = (i - a.i) / (b.i - a.i);
    const double base_j = a.j + along * (b.j - a.j), from_pole = (j - t.corner[apex].j) / (base_j - t.corner[apex].j);
    if (!(along >= kInside && along <= 1 - kInside)) return kOutside;
    Weights weights;
    weights.at[apex] = 1 - from_pole;
    weights.at[first] = from_pole * (1 - along);
    weights.at[second] = from_pole * along;
    return weights;
}

Weights weights_of(const Triangle& t, double i, double j) {
    std::uint32_t poles = 0, apex = 0;
    for (std::uint32_t n = 0; n < 3; ++n) {
        if (!t.corner[n].is_pole) continue;
        ++poles;
        apex = n;
    }
    if (poles == 0) return plain_weights(t, i, j);
    return poles == 1 ? polar_weights(t, apex, i, j) : kOutside;
}

bool is_pole_row(const Lattice& lattice, std::uint32_t j) {
    return ((lattice.flags() & kLatticeNorthPole) != 0 && j == 0) ||
           ((lattice.flags() & kLatticeSouthPole) != 0 && j == lattice.rows() - 1);
}

struct Found {
    std::size_t triangle = 0;
    Weights weights = kOutside;
};

/// The triangle that holds the point; of two that share it, the first.
Found find_triangle(const Lattice& lattice, const PostRange& posts, const DrawnMesh& mesh, double i, double j) {
    Found best;
    for (std::size_t n = 0; n + 2 < mesh.indices.size(); n += 3) {
        Triangle t;
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const ChunkVertex& v = mesh.vertices[mesh.indices[n + corner]];
            t.corner[corner] = {double(v.i), double(v.j), is_pole_row(lattice, posts.j0 + v.j)};
        }
        const Weights weights = weights_of(t, i, j);
        if (weights.least() > best.weights.least()) best = {n, weights};
        if (best.weights.least() >= 0) break;
    }
    return best;
}

}  // namespace

float vertex_lift_m(const ChunkLift& lift, const PostRange& posts, const ChunkVertex& vertex) {
    const std::uint32_t last_i = posts.i1 - posts.i0, last_j = posts.j1 - posts.j0;
    const bool west = vertex.i == 0, east = vertex.i == last_i, north = vertex.j == 0, south = vertex.j == last_j;
    if ((north || south) && (west || east)) return lift.corner_m[(east ? 1u : 0u) + (south ? 2u : 0u)];
    if (north) return lift.edge_m[0];
    if (east) return lift.edge_m[1];
    if (south) return lift.edge_m[2];
    return west ? lift.edge_m[3] : lift.own_m;
}

glm::dvec3 drawn_position(const Lattice& lattice, const SelectedChunk& chunk, const PostRange& posts, const ChunkVertex& v) {
    const glm::dvec3 place(double{v.x}, double{v.y}, double{v.z});
    const double lift_m = double{vertex_lift_m(chunk.lift, posts, v)};
    if (lift_m == 0) return place;
    const std::uint32_t i = posts.i0 + v.i, j = posts.j0 + v.j;
    return place + lattice.position(i, j, lift_m) - lattice.position(i, j, 0);
}

const SelectedChunk* chunk_under(const Lattice& lattice, base::Span<const SelectedChunk> selected, const LatticePoint& point) {
    if (!point.inside) return nullptr;
    const auto i = static_cast<std::uint32_t>(std::fmin(point.i, lattice.columns() - 2.0));
    const auto j = static_cast<std::uint32_t>(std::fmin(point.j, lattice.rows() - 2.0));
    for (const SelectedChunk& chunk : selected) {
        const PostRange posts = lattice.posts_of(chunk.key);
        if (i >= posts.i0 && i < posts.i1 && j >= posts.j0 && j < posts.j1) return &chunk;
    }
    return nullptr;
}

DrawnPoint drawn_point(const TerrainDatabase& database, const DrawnMesh& mesh, const LatticePoint& point) {
    const SelectedChunk& chunk = *mesh.chunk;
    const PostRange posts = database.lattice().posts_of(chunk.key);
    const Found found = find_triangle(database.lattice(), posts, mesh, point.i - posts.i0, point.j - posts.j0);
    if (!(found.weights.least() >= kInside)) return {};
    DrawnPoint drawn;
    drawn.found = true;
    glm::dvec3 offset(0);
    std::uint32_t heaviest = 0;
    bool is_void = false;
    for (std::uint32_t n = 0; n < 3; ++n) {
        const ChunkVertex& v = mesh.vertices[mesh.indices[found.triangle + n]];
        offset += drawn_position(database.lattice(), chunk, posts, v) * found.weights.at[n];
        is_void = is_void || v.post_class() == PostClass::void_;
        if (found.weights.at[n] > found.weights.at[heaviest]) heaviest = n;
    }
    drawn.position = glm::dvec3(chunk.entry->centre_m[0], chunk.entry->centre_m[1], chunk.entry->centre_m[2]) + offset;
    drawn.post_class = is_void ? PostClass::void_ : mesh.vertices[mesh.indices[found.triangle + heaviest]].post_class();
    const earth::Geodetic place = earth::from_ecef(drawn.position);
    drawn.height = earth::to_msl(place.height, database.undulation(place.latitude_rad, place.longitude_rad));
    return drawn;
}

}  // namespace tedavis::terrain
