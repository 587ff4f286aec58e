#include "host_sim/terrain_builder/mesh_levels.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::kChunkCells;
using terrain::LatticeTriangle;
using terrain::LatticeVertex;
using terrain::PostClass;

constexpr double kLeastRadius_m = 6335000;  // below the least radius of curvature of WGS84

bool inside(const Lattice& lattice, LatticeVertex v) {
    return v.i >= 0 && v.j >= 0 && v.i < lattice.columns && v.j < lattice.rows;
}

/// The plane through a triangle's corners, in heights over lattice coordinates.
struct Plane {
    double height, per_i, per_j;
    LatticeVertex origin;

    Plane(const Lattice& lattice, const LatticeTriangle& t) : origin(t.c) {
        const double hc = lattice.surface_m[lattice.at(t.c.i, t.c.j)];
        const double ha = lattice.surface_m[lattice.at(t.a.i, t.a.j)] - hc, hb = lattice.surface_m[lattice.at(t.b.i, t.b.j)] - hc;
        const double ai = static_cast<double>(t.a.i - t.c.i), aj = static_cast<double>(t.a.j - t.c.j);
        const double bi = static_cast<double>(t.b.i - t.c.i), bj = static_cast<double>(t.b.j - t.c.j);
        const double area = ai * bj - aj * bi;
        height = hc;
        per_i = (ha * bj - hb * aj) / area;
        per_j = (hb * ai - ha * bi) / area;
    }
    [[nodiscard]] double at(double i, double j) const {
        return height + per_i * (i - static_cast<double>(origin.i)) + per_j * (j - static_cast<double>(origin.j));
    }
};

/// Closed interval of i (in half cells) that a row at j2/2 cuts from the triangle.
struct RowRange {
    std::int64_t first2, last2;
};

RowRange row_range(const LatticeTriangle& t, std::int64_t j2) {
    const LatticeVertex corners[3] = {t.a, t.b, t.c};
    std::int64_t first = INT64_MAX, last = INT64_MIN;
    for (int n = 0; n < 3; ++n) {
        const LatticeVertex p = corners[n], q = corners[(n + 1) % 3];
        if (std::min(p.j, q.j) * 2 > j2 || std::max(p.j, q.j) * 2 < j2) continue;
        // Edges are axis-parallel or diagonal, so cuts of half rows are whole half cells.
        const auto add = [&](std::int64_t i2) {
            first = std::min(first, i2);
            last = std::max(last, i2);
        };
        if (p.j == q.j) {
            add(2 * p.i);
            add(2 * q.i);
        } else {
            add(2 * p.i + (q.i - p.i) * (j2 - 2 * p.j) / (q.j - p.j));
        }
    }
    return {first, last};
}

struct Extremes {
    double above = 0, below = 0;
    std::int64_t voids = 0, posts = 0;
    bool void_cells = false;  ///< a cell that the triangle covers in part has a void corner
};

void scan_posts(const Lattice& lattice, const Plane& plane, std::int64_t j, std::int64_t first, std::int64_t last,
                Extremes& extremes) {
    const std::size_t row = lattice.at(0, j);
    for (std::int64_t i = first; i <= last; ++i) {
        const std::size_t n = row + static_cast<std::size_t>(i);
        ++extremes.posts;
        if (lattice.post_class[n] == PostClass::void_) {
            ++extremes.voids;
            continue;
        }
        const double difference = plane.at(static_cast<double>(i), static_cast<double>(j)) - lattice.surface_m[n];
        extremes.above = std::max(extremes.above, difference);
        extremes.below = std::max(extremes.below, -difference);
    }
}

void scan_centres(const Lattice& lattice, const Plane& plane, std::int64_t j, std::int64_t first, std::int64_t last,
                  Extremes& extremes) {
    for (std::int64_t i = first; i <= last; ++i) {
        const std::size_t north_west = lattice.at(i, j), north_east = north_west + 1, south_west = lattice.at(i, j + 1),
                          south_east = south_west + 1;
        for (const std::size_t corner : {north_west, north_east, south_west, south_east})
            extremes.void_cells = extremes.void_cells || lattice.post_class[corner] == PostClass::void_;
        const double truth = 0.5 * (static_cast<double>(lattice.surface_m[north_east]) + lattice.surface_m[south_west]);
        const double difference = plane.at(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5) - truth;
        extremes.above = std::max(extremes.above, difference);
        extremes.below = std::max(extremes.below, -difference);
    }
}

/// What the true surface's diagonal can differ from the network's alternating one in a cell.
double diagonal_error(const Lattice& lattice, std::int64_t i, std::int64_t j) {
    if (((i + j) & 1) != 0 || i < 0 || j < 0 || i + 1 >= lattice.raster_columns || j + 1 >= lattice.raster_rows) return 0;
    const double diagonal =
        static_cast<double>(lattice.surface_m[lattice.at(i, j)]) + lattice.surface_m[lattice.at(i + 1, j + 1)];
    const double other = static_cast<double>(lattice.surface_m[lattice.at(i + 1, j)]) + lattice.surface_m[lattice.at(i, j + 1)];
    return 0.5 * std::abs(diagonal - other);
}

/// The two triangles that `v` splits: hypotenuse round v, apexes its parents.
struct SplitPair {
    LatticeTriangle first, second;
};

SplitPair triangles_of(LatticeVertex v) {
    const terrain::VertexParents parents = terrain::parents_of(v);
    // A quarter turn of a parent about v is an end of the hypotenuse.
    const LatticeVertex a{v.i - (parents.first.j - v.j), v.j + (parents.first.i - v.i)};
    const LatticeVertex b{v.i + (parents.first.j - v.j), v.j - (parents.first.i - v.i)};
    return {{a, b, parents.first}, {b, a, parents.second}};
}

bool is_inside(const Lattice& lattice, const LatticeTriangle& t) {
    return inside(lattice, t.a) && inside(lattice, t.b) && inside(lattice, t.c);
}

bool beyond_raster(const Lattice& lattice, const LatticeTriangle& t) {
    return std::min({t.a.i, t.b.i, t.c.i}) >= lattice.raster_columns - 1 ||
           std::min({t.a.j, t.b.j, t.c.j}) >= lattice.raster_rows - 1;
}

float own_error(const Lattice& lattice, LatticeVertex v) {
    const SplitPair pair = triangles_of(v);
    double error = 0;
    for (const LatticeTriangle& t : {pair.first, pair.second}) {
        if (!is_inside(lattice, t) || beyond_raster(lattice, t)) continue;
        const SignedError measured = measure_triangle(lattice, t);
        if (measured.mixed) return kAlwaysNeeded;
        error = std::max({error, measured.above_m, measured.below_m});
    }
    if (terrain::lattice_scale(v) == 1)
        for (std::int64_t dj = -1; dj <= 0; ++dj)
            for (std::int64_t di = -1; di <= 0; ++di) error = std::max(error, diagonal_error(lattice, v.i + di, v.j + dj));
    return std::nextafterf(static_cast<float>(error), kAlwaysNeeded);
}

/// Vertices whose parents include v.
void raise_to_children(const Lattice& lattice, const std::vector<float>& errors, LatticeVertex v, bool centre, std::int64_t scale,
                       float& error) {
    const std::int64_t d = centre ? scale : scale / 2;
    if (d == 0) return;
    const std::int64_t axis[4][2] = {{d, 0}, {-d, 0}, {0, d}, {0, -d}};
    const std::int64_t diagonal[4][2] = {{d, d}, {-d, d}, {d, -d}, {-d, -d}};
    for (const auto& step : centre ? axis : diagonal) {
        const LatticeVertex child{v.i + step[0], v.j + step[1]};
        if (inside(lattice, child)) error = std::max(error, errors[lattice.at(child.i, child.j)]);
    }
}

/// Calls f(vertex) for every vertex of a scale: axis vertices (one coordinate odd) or centres (both odd).
template <class F>
void for_each_vertex(const Lattice& lattice, std::int64_t scale, bool centres, F f) {
    for (std::int64_t j = 0; j < lattice.rows; j += scale) {
        const bool j_odd = ((j / scale) & 1) != 0;
        const std::int64_t first = centres || !j_odd ? scale : 0;
        if (centres && !j_odd) continue;
        for (std::int64_t i = first; i < lattice.columns; i += 2 * scale) f(LatticeVertex{i, j});
    }
}

std::int64_t top_side(const Lattice& lattice) { return std::int64_t{kChunkCells} << (lattice.levels - 1); }

/// Keeps a vertex and everything it depends on up to a level.
void require(const Lattice& lattice, std::vector<std::uint8_t>& levels, LatticeVertex vertex, std::uint8_t level) {
    const std::uint8_t before = levels[lattice.at(vertex.i, vertex.j)];
    if (before != kNeverNeeded && before >= level) return;
    std::vector<LatticeVertex> open{vertex};
    while (!open.empty()) {
        const LatticeVertex v = open.back();
        open.pop_back();
        if (!inside(lattice, v)) continue;
        std::uint8_t& kept = levels[lattice.at(v.i, v.j)];
        if (kept != kNeverNeeded && kept >= level) continue;
        kept = level;
        if (terrain::lattice_scale(v) >= top_side(lattice) || (v.i == 0 && v.j == 0)) continue;
        const terrain::VertexParents parents = terrain::parents_of(v);
        open.push_back(parents.first);
        open.push_back(parents.second);
    }
}

void keep_chunk_corners(const Lattice& lattice, std::vector<std::uint8_t>& levels) {
    for (std::uint32_t level = 0; level < lattice.levels; ++level) {
        const std::int64_t side = std::int64_t{kChunkCells} << level;
        const auto kept = static_cast<std::uint8_t>(std::min(level + 1, lattice.levels - 1));
        for (std::int64_t j = 0; j < lattice.rows; j += side)
            for (std::int64_t i = 0; i < lattice.columns; i += side) require(lattice, levels, {i, j}, kept);
    }
}

/// A vertex on a border line of chunks depends, through its parents, on vertices of other borders near a corner. Those
/// are kept one level longer, so that what a chunk leaves out along one border never reaches another.
class BorderSeparator {
public:
    BorderSeparator(const Lattice& lattice, std::vector<std::uint8_t>& levels)
        : lattice_(lattice), levels_(levels), seen_(levels.size(), 0) {}

    void run() {
        for (level_ = 0; level_ + 1 < lattice_.levels; ++level_) {
            side_ = std::int64_t{kChunkCells} << level_;
            for (std::int64_t j = 0; j < lattice_.rows; j += side_) {
                ++line_;
                for (std::int64_t i = 0; i < lattice_.columns; ++i) visit({i, j}, true);
            }
            for (std::int64_t i = 0; i < lattice_.columns; i += side_) {
                ++line_;
                for (std::int64_t j = 0; j < lattice_.rows; ++j) visit({i, j}, false);
            }
        }
    }

private:
    void visit(LatticeVertex start, bool on_row) {
        const std::uint8_t kept = levels_[lattice_.at(start.i, start.j)];
        if (kept == kNeverNeeded || kept < level_ || terrain::lattice_scale(start) >= side_) return;
        open_.assign(1, start);
        while (!open_.empty()) {
            const LatticeVertex v = open_.back();
            open_.pop_back();
            if (!inside(lattice_, v) || terrain::lattice_scale(v) >= side_ || (v.i == 0 && v.j == 0)) continue;
            // Ancestors seen from an earlier vertex of this line have been followed already.
            if (seen_[lattice_.at(v.i, v.j)] == line_) continue;
            seen_[lattice_.at(v.i, v.j)] = line_;
            const bool same_line = on_row ? v.j == start.j : v.i == start.i;
            if ((v.i % side_ == 0 || v.j % side_ == 0) && !same_line) {
                require(lattice_, levels_, v, static_cast<std::uint8_t>(level_ + 1));
                continue;  // its ancestors are kept with it
            }
            const terrain::VertexParents parents = terrain::parents_of(v);
            open_.push_back(parents.first);
            open_.push_back(parents.second);
        }
    }

    const Lattice& lattice_;
    std::vector<std::uint8_t>& levels_;
    std::vector<std::uint32_t> seen_;  // the line from which a vertex was last followed
    std::vector<LatticeVertex> open_;
    std::uint32_t level_ = 0, line_ = 0;
    std::int64_t side_ = 0;
};

}  // namespace

double sagitta_m(double hypotenuse_m) { return hypotenuse_m * hypotenuse_m / (8 * kLeastRadius_m); }

SignedError measure_triangle(const Lattice& lattice, const LatticeTriangle& triangle) {
    const Plane plane(lattice, triangle);
    const std::int64_t first_j = std::min({triangle.a.j, triangle.b.j, triangle.c.j});
    const std::int64_t last_j = std::min(std::max({triangle.a.j, triangle.b.j, triangle.c.j}), lattice.raster_rows - 1);
    Extremes extremes;
    for (std::int64_t j = first_j; j <= last_j; ++j) {
        const RowRange row = row_range(triangle, 2 * j);
        scan_posts(lattice, plane, j, (row.first2 + 1) / 2, std::min(row.last2 / 2, lattice.raster_columns - 1), extremes);
        if (j == last_j) break;
        const RowRange half = row_range(triangle, 2 * j + 1);
        scan_centres(lattice, plane, j, half.first2 / 2, std::min((half.last2 - 1) / 2, lattice.raster_columns - 2), extremes);
    }
    SignedError error;
    error.mixed = extremes.voids != extremes.posts && (extremes.voids != 0 || extremes.void_cells);
    if (extremes.voids != 0 || extremes.void_cells) return error;
    const double di = static_cast<double>(triangle.a.i - triangle.b.i), dj = static_cast<double>(triangle.a.j - triangle.b.j);
    error.above_m = extremes.above;
    error.below_m = extremes.below + sagitta_m(std::hypot(di, dj) * lattice.cell_m);
    return error;
}

std::vector<float> measure_errors(const Lattice& lattice, const std::function<void()>& pulse) {
    std::vector<float> errors(static_cast<std::size_t>(lattice.columns * lattice.rows), 0.0f);
    for (std::int64_t scale = 1; scale < top_side(lattice); scale *= 2) {
        for (const bool centres : {false, true}) {
            if (pulse) pulse();
            for_each_vertex(lattice, scale, centres, [&](LatticeVertex v) {
                float error = own_error(lattice, v);
                raise_to_children(lattice, errors, v, centres, scale, error);
                errors[lattice.at(v.i, v.j)] = error;
            });
        }
    }
    return errors;
}

std::vector<std::uint8_t> assign_levels(const Lattice& lattice, const std::vector<float>& errors,
                                        const std::array<float, 16>& tolerance_m) {
    std::vector<std::uint8_t> levels(errors.size(), kNeverNeeded);
    for (std::size_t n = 0; n < errors.size(); ++n)
        for (std::uint32_t level = 0; level < lattice.levels && errors[n] > tolerance_m[level]; ++level)
            levels[n] = static_cast<std::uint8_t>(level);
    keep_chunk_corners(lattice, levels);
    BorderSeparator(lattice, levels).run();
    return levels;
}

}  // namespace tedavis::host_sim
