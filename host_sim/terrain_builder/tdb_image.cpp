#include "host_sim/terrain_builder/tdb_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/chunk_mesh.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

// Chosen so that a chunk is used at about its own size away: tolerance / (side in metres) is the angle of a pixel there.
constexpr double kToleranceOfCell = 0.05;
constexpr float kExactTolerance_m = 0.0005f;
constexpr float kLoosen = 1.1f;
constexpr std::size_t kTargetChunkVertices = kMaxChunkVertices * 9 / 10;
constexpr float kUselessTolerance_m = 2000;
constexpr double kFinestQuantum_m = 1.0 / 1024;
constexpr double kReachOfHeights_m = 5000;  // half the range of heights that a raster may hold

double post_longitude(const Raster& raster, std::int64_t i) {
    return raster.west_deg + raster.step_lon_deg * static_cast<double>(i);
}
double post_latitude(const Raster& raster, std::int64_t j) {
    return std::max(-90.0, raster.north_deg - raster.step_lat_deg * static_cast<double>(j));
}

double grid_undulation(const TerrainModel& model, double latitude_deg, double longitude_deg) {
    const double x = (longitude_deg - model.undulation_west_deg) / kUndulationStep_deg;
    const double y = (model.undulation_north_deg - latitude_deg) / kUndulationStep_deg;
    const double i = std::min(std::max(std::floor(x), 0.0), model.undulation_columns - 2.0);
    const double j = std::min(std::max(std::floor(y), 0.0), model.undulation_rows - 2.0);
    const double u = std::min(std::max(x - i, 0.0), 1.0), v = std::min(std::max(y - j, 0.0), 1.0);
    const float* p =
        model.undulation_m.data() + static_cast<std::size_t>(j) * model.undulation_columns + static_cast<std::size_t>(i);
    const std::uint32_t row = model.undulation_columns;
    return (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * ((1 - u) * p[row] + u * p[row + 1]);
}

void cut_geoid(TerrainModel& model) {
    const Raster& r = model.raster;
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const double south_deg = post_latitude(r, r.rows - 1), east_deg = post_longitude(r, r.columns - 1);
    model.undulation_west_deg = std::floor(r.west_deg / kUndulationStep_deg) * kUndulationStep_deg;
    model.undulation_north_deg = std::ceil(r.north_deg / kUndulationStep_deg) * kUndulationStep_deg;
    model.undulation_columns =
        static_cast<std::uint32_t>(std::ceil((east_deg - model.undulation_west_deg) / kUndulationStep_deg)) + 1;
    model.undulation_rows =
        static_cast<std::uint32_t>(std::ceil((model.undulation_north_deg - south_deg) / kUndulationStep_deg)) + 1;
    model.undulation_columns = std::max(model.undulation_columns, 2u);
    model.undulation_rows = std::max(model.undulation_rows, 2u);
    for (std::uint32_t j = 0; j < model.undulation_rows; ++j)
        for (std::uint32_t i = 0; i < model.undulation_columns; ++i)
            model.undulation_m.push_back(static_cast<float>(
                geoid
                    .undulation(base::radians(std::max(-90.0, model.undulation_north_deg - kUndulationStep_deg * j)),
                                base::radians(model.undulation_west_deg + kUndulationStep_deg * i))
                    .m));
}

/// Posts beyond the raster repeat its last row and column, so that edge chunks are whole; they are never drawn.
void fill_lattice(TerrainModel& model) {
    const Raster& r = model.raster;
    Lattice& l = model.lattice;
    l.surface_m.resize(static_cast<std::size_t>(l.columns * l.rows));
    l.post_class.resize(l.surface_m.size());
    for (std::int64_t j = 0; j < l.rows; ++j) {
        for (std::int64_t i = 0; i < l.columns; ++i) {
            const std::int64_t source_i = std::min<std::int64_t>(i, r.columns - 1),
                               source_j = std::min<std::int64_t>(j, r.rows - 1);
            const std::size_t from = r.at(static_cast<std::uint32_t>(source_i), static_cast<std::uint32_t>(source_j));
            const bool outside = i != source_i || j != source_j;
            const bool is_void = r.post_class[from] == PostClass::void_;
            const double undulation = grid_undulation(model, post_latitude(r, source_j), post_longitude(r, source_i));
            l.surface_m[l.at(i, j)] = is_void ? 0.0f : static_cast<float>(r.height_m[from] + undulation);
            l.post_class[l.at(i, j)] = outside ? (is_void ? PostClass::void_ : PostClass::outside) : r.post_class[from];
        }
    }
}

void size_lattice(TerrainModel& model, std::uint32_t levels) {
    const Raster& r = model.raster;
    Lattice& l = model.lattice;
    const std::int64_t side = std::int64_t{kChunkCells} << (levels - 1);
    l.levels = levels;
    l.raster_columns = r.columns;
    l.raster_rows = r.rows;
    l.columns = (r.columns - 1 + side - 1) / side * side + 1;
    l.rows = (r.rows - 1 + side - 1) / side * side + 1;
    const double north_m = base::radians(r.step_lat_deg) * 6400000.0;  // above the largest radius of curvature: never too small
    const double nearest_equator =
        std::max(std::cos(base::radians(r.north_deg)), std::cos(base::radians(post_latitude(r, r.rows - 1))));
    const bool spans_equator = r.north_deg > 0 && post_latitude(r, r.rows - 1) < 0;
    l.cell_m = std::max(north_m, base::radians(r.step_lon_deg) * 6400000.0 * (spans_equator ? 1.0 : nearest_equator));
}

std::uint32_t useful_levels(const Raster& raster) {
    std::uint32_t levels = 1;
    const std::uint32_t longer = std::max(raster.columns, raster.rows) - 1;
    while (levels < kMaxLevels && (std::uint64_t{kChunkCells} << (levels - 1)) < longer) ++levels;
    return levels;
}

/// Vertices a chunk of the level would have.
std::uint32_t vertices_in(const TerrainModel& model, std::uint32_t level, std::int64_t ci, std::int64_t cj) {
    const Lattice& l = model.lattice;
    const std::int64_t side = std::int64_t{kChunkCells} << level;
    std::uint32_t count = 0;
    for (std::int64_t j = cj * side; j <= (cj + 1) * side; ++j)
        for (std::int64_t i = ci * side; i <= (ci + 1) * side; ++i) {
            const std::uint8_t kept = model.levels[l.at(i, j)];
            count += kept != kNeverNeeded && kept >= level ? 1 : 0;
        }
    return count;
}

bool level_fits(const TerrainModel& model, std::uint32_t level) {
    const std::int64_t side = std::int64_t{kChunkCells} << level;
    for (std::int64_t j = 0; j * side < model.lattice.raster_rows - 1; ++j)
        for (std::int64_t i = 0; i * side < model.lattice.raster_columns - 1; ++i)
            if (vertices_in(model, level, i, j) > kMaxChunkVertices) return false;
    return true;
}

/// The first level with a chunk over capacity; `levels` when all fit.
std::uint32_t first_overfull_level(const TerrainModel& model) {
    std::uint32_t level = 0;
    while (level < model.lattice.levels && level_fits(model, level)) ++level;
    return level;
}

/// The tolerance at which no chunk of the level keeps more than `target` posts by its errors alone.
float tolerance_for(const TerrainModel& model, std::uint32_t level, std::size_t target) {
    const Lattice& l = model.lattice;
    const std::int64_t side = std::int64_t{kChunkCells} << level;
    std::vector<float> errors;
    float tolerance = 0;
    for (std::int64_t cj = 0; cj * side < l.raster_rows - 1; ++cj)
        for (std::int64_t ci = 0; ci * side < l.raster_columns - 1; ++ci) {
            errors.clear();
            for (std::int64_t j = cj * side; j <= (cj + 1) * side; ++j)
                for (std::int64_t i = ci * side; i <= (ci + 1) * side; ++i)
                    if (model.errors_m[l.at(i, j)] > tolerance) errors.push_back(model.errors_m[l.at(i, j)]);
            if (errors.size() <= target) continue;
            std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(target), errors.end(),
                             std::greater<>());
            tolerance = errors[target];
        }
    return tolerance;
}

/// Tolerances that grow with the level and let every chunk fit; false when none does (borders of voids are always kept).
bool fit_tolerances(TerrainModel& model) {
    model.tolerance_m = {};
    model.tolerance_m[0] = kExactTolerance_m;
    for (std::uint32_t level = 1; level < model.lattice.levels; ++level) {
        const auto wanted = static_cast<float>(kToleranceOfCell * model.lattice.cell_m * std::exp2(level));
        model.tolerance_m[level] =
            std::max({wanted, model.tolerance_m[level - 1], tolerance_for(model, level, kTargetChunkVertices)});
        if (model.tolerance_m[level] > kUselessTolerance_m) return false;
    }
    for (;;) {
        model.levels = assign_levels(model.lattice, model.errors_m, model.tolerance_m);
        const std::uint32_t overfull = first_overfull_level(model);
        if (overfull == model.lattice.levels) return true;
        if (overfull == 0 || model.tolerance_m[overfull] > kUselessTolerance_m) return false;
        // Corners and separated borders took more than the room left for them.
        model.tolerance_m[overfull] *= kLoosen;
        for (std::uint32_t level = overfull + 1; level < model.lattice.levels; ++level)
            model.tolerance_m[level] = std::max(model.tolerance_m[level], model.tolerance_m[level - 1]);
    }
}

struct LatticeOrder {
    std::int64_t scale;
    int axis;
    std::int64_t j, i;
    [[nodiscard]] bool operator<(const LatticeOrder& o) const {
        if (scale != o.scale) return scale > o.scale;
        if (axis != o.axis) return axis < o.axis;
        return j != o.j ? j < o.j : i < o.i;
    }
};

/// Coarse before fine, centres before axis vertices: parents come before children.
LatticeOrder order_of(LatticeVertex v) {
    const std::int64_t scale = v.i == 0 && v.j == 0 ? INT64_MAX : lattice_scale(v);
    const bool centre = scale != INT64_MAX && ((v.i / scale) & 1) != 0 && ((v.j / scale) & 1) != 0;
    return {scale, centre ? 0 : 1, v.j, v.i};
}

/// Builds chunks of one model.
class ChunkWriter {
public:
    explicit ChunkWriter(const TerrainModel& model) : model_(model), l_(model.lattice), r_(model.raster) {}

    void write(std::uint32_t level, std::uint32_t ci, std::uint32_t cj, ChunkEntry& entry, std::vector<std::uint8_t>& payload) {
        side_ = std::int64_t{kChunkCells} << level;
        west_ = ci * side_;
        north_ = cj * side_;
        entry = ChunkEntry{};
        entry.level = static_cast<std::uint16_t>(level);
        entry.i = ci;
        entry.j = cj;
        place_box(entry);
        std::vector<ChunkVertex> vertices = make_vertices(entry);
        measure(entry, vertices);
        payload.resize(vertices.size() * sizeof(ChunkVertex));
        std::memcpy(payload.data(), vertices.data(), payload.size());
        if (level == 0) append_posts(payload);
        entry.bytes = static_cast<std::uint32_t>(payload.size());
        entry.crc = base::crc32(payload.data(), payload.size());
    }

private:
    [[nodiscard]] glm::dvec3 ecef(std::int64_t i, std::int64_t j) const {
        return earth::to_ecef(
            {base::radians(post_latitude(r_, j)), base::radians(post_longitude(r_, i)), {l_.surface_m[l_.at(i, j)]}});
    }

    void place_box(ChunkEntry& entry) {
        const double latitude = base::radians(post_latitude(r_, north_ + side_ / 2)),
                     longitude = base::radians(post_longitude(r_, west_ + side_ / 2));
        float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
        entry.min_height_m = low;
        entry.max_height_m = high;
        for (std::int64_t j = north_; j <= std::min<std::int64_t>(north_ + side_, r_.rows - 1); ++j)
            for (std::int64_t i = west_; i <= std::min<std::int64_t>(west_ + side_, r_.columns - 1); ++i) {
                if (l_.post_class[l_.at(i, j)] == PostClass::void_) {
                    entry.flags |= kChunkHasVoid;
                    continue;
                }
                low = std::min(low, l_.surface_m[l_.at(i, j)]);
                high = std::max(high, l_.surface_m[l_.at(i, j)]);
                const float height = r_.height_m[r_.at(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))];
                entry.min_height_m = std::min(entry.min_height_m, height);
                entry.max_height_m = std::max(entry.max_height_m, height);
            }
        if (low > high) low = high = entry.min_height_m = entry.max_height_m = 0;
        if (west_ + side_ > r_.columns - 1 || north_ + side_ > r_.rows - 1) entry.flags |= kChunkHasOutside;
        const glm::dvec3 centre = earth::to_ecef({latitude, longitude, {0.5 * (low + high)}});
        const glm::dmat3 axes = earth::north_east_down(latitude, longitude);
        for (int a = 0; a < 3; ++a) {
            entry.centre_m[a] = std::round(centre[a]);
            for (int b = 0; b < 3; ++b) entry.axes[3 * a + b] = static_cast<float>(axes[a][b]);
        }
    }

    /// A power of two so that every chunk that shares the vertex can hold it exactly in a float.
    [[nodiscard]] double quantum(std::uint32_t top_level) const {
        // No vertex lies further from its chunk's centre than half the diagonal, and the heights beside it.
        const double reach_m = kReachOfHeights_m + 0.75 * l_.cell_m * static_cast<double>(std::int64_t{kChunkCells} << top_level);
        return std::max(kFinestQuantum_m, std::exp2(std::ceil(std::log2(reach_m / 16777216.0))));
    }

    [[nodiscard]] std::vector<ChunkVertex> make_vertices(const ChunkEntry& entry) {
        std::vector<LatticeVertex> chosen;
        for (std::int64_t j = north_; j <= north_ + side_; ++j)
            for (std::int64_t i = west_; i <= west_ + side_; ++i) {
                const std::uint8_t kept = model_.levels[l_.at(i, j)];
                if (kept != kNeverNeeded && kept >= entry.level) chosen.push_back({i, j});
            }
        std::sort(chosen.begin(), chosen.end(), [](LatticeVertex a, LatticeVertex b) { return order_of(a) < order_of(b); });
        std::vector<ChunkVertex> vertices;
        rounding_m_ = 0;
        for (const LatticeVertex v : chosen) vertices.push_back(make_vertex(entry, v));
        return vertices;
    }

    [[nodiscard]] ChunkVertex make_vertex(const ChunkEntry& entry, LatticeVertex v) {
        const std::uint8_t kept = model_.levels[l_.at(v.i, v.j)];
        const glm::dvec3 position = ecef(v.i, v.j);
        const double q = quantum(kept);
        glm::dvec3 local;
        for (int a = 0; a < 3; ++a) local[a] = std::round(position[a] / q) * q - entry.centre_m[a];
        rounding_m_ = std::max(rounding_m_, 0.5 * std::sqrt(3.0) * q);
        ChunkVertex out{};
        out.x = static_cast<float>(local.x);
        out.y = static_cast<float>(local.y);
        out.z = static_cast<float>(local.z);
        const std::int64_t i = std::min<std::int64_t>(v.i, r_.columns - 1), j = std::min<std::int64_t>(v.j, r_.rows - 1);
        const float height = r_.height_m[r_.at(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))];
        out.height_m = std::isnan(height) ? 0.0f : height;
        const glm::dvec3 normal = normal_at(v.i, v.j);
        for (int a = 0; a < 3; ++a) out.normal[a] = static_cast<std::int8_t>(std::lround(normal[a] * 127));
        out.level_and_class = static_cast<std::uint8_t>(kept | (static_cast<unsigned>(l_.post_class[l_.at(v.i, v.j)]) << 4));
        out.i = static_cast<std::uint16_t>(v.i - west_);
        out.j = static_cast<std::uint16_t>(v.j - north_);
        return out;
    }

    /// Central differences over valid neighbours; the vertical where there are none.
    [[nodiscard]] glm::dvec3 normal_at(std::int64_t i, std::int64_t j) const {
        const auto valid = [&](std::int64_t a, std::int64_t b) {
            return a >= 0 && b >= 0 && a < l_.raster_columns && b < l_.raster_rows &&
                   l_.post_class[l_.at(a, b)] != PostClass::void_;
        };
        const glm::dmat3 axes = earth::north_east_down(base::radians(post_latitude(r_, j)), base::radians(post_longitude(r_, i)));
        const std::int64_t west = valid(i - 1, j) ? i - 1 : i, east = valid(i + 1, j) ? i + 1 : i;
        const std::int64_t north = valid(i, j - 1) ? j - 1 : j, south = valid(i, j + 1) ? j + 1 : j;
        if (!valid(i, j) || west == east || north == south) return -axes[2];
        const glm::dvec3 normal = glm::cross(ecef(east, j) - ecef(west, j), ecef(i, north) - ecef(i, south));
        return glm::normalize(normal);
    }

    void measure(ChunkEntry& entry, const std::vector<ChunkVertex>& vertices) {
        entry.vertex_count = static_cast<std::uint32_t>(vertices.size());
        if (vertices.size() > kMaxChunkVertices)
            throw UserError("terrain build: chunk " + std::to_string(entry.level) + "/" + std::to_string(entry.i) + "/" +
                            std::to_string(entry.j) + " needs more than " + std::to_string(kMaxChunkVertices) +
                            " vertices; report this raster");
        std::vector<std::uint16_t> indices(3 * kMaxChunkTriangles);
        const base::Span<const ChunkVertex> span(vertices.data(), vertices.size());
        const MeshCount mesh = build_chunk_indices(span, {entry.level, entry.i, entry.j, r_.columns - 1, r_.rows - 1}, 0,
                                                   scratch_, base::Span<std::uint16_t>(indices.data(), indices.size()));
        if (!mesh.sound) throw UserError("terrain build: the mesh of a chunk is not conforming; report this raster");
        entry.triangle_count = mesh.indices / 3;
        measure_mesh(entry, vertices, indices, mesh.indices);
        grow_box(entry, vertices);
        entry.bound_m = static_cast<float>(bound_of(entry) + rounding_m_);
    }

    /// Exhaustive over the drawn triangles.
    void measure_mesh(ChunkEntry& entry, const std::vector<ChunkVertex>& vertices, const std::vector<std::uint16_t>& indices,
                      std::uint32_t count) {
        double above = 0, below = 0;
        for (std::uint32_t n = 0; n < count; n += 3) {
            LatticeVertex c[3];
            for (int k = 0; k < 3; ++k) c[k] = {west_ + vertices[indices[n + k]].i, north_ + vertices[indices[n + k]].j};
            if (is_exact_cell_half(c)) continue;
            const SignedError error = measure_triangle(l_, {c[0], c[1], c[2]});
            above = std::max(above, error.above_m);
            below = std::max(below, error.below_m);
        }
        entry.above_m = static_cast<float>(above + rounding_m_);
        entry.below_m = static_cast<float>(below + rounding_m_);
    }
    /// Half a cell cut along the true diagonal is the true surface itself.
    [[nodiscard]] static bool is_exact_cell_half(const LatticeVertex (&c)[3]) {
        const std::int64_t i = std::min({c[0].i, c[1].i, c[2].i}), j = std::min({c[0].j, c[1].j, c[2].j});
        int on_diagonal = 0;
        for (const LatticeVertex& v : c) {
            if (v.i > i + 1 || v.j > j + 1) return false;
            on_diagonal += (v.i - i) + (v.j - j) == 1 ? 1 : 0;
        }
        return on_diagonal == 2;
    }

    /// Largest error of any post that this level leaves out, in the chunk and half a chunk round it: see lod_selection.hpp.
    [[nodiscard]] double bound_of(const ChunkEntry& entry) const {
        const std::int64_t margin = entry.level == 0 ? 0 : side_ / 2;
        float bound = 0;
        for (std::int64_t j = std::max<std::int64_t>(0, north_ - margin); j <= std::min(l_.rows - 1, north_ + side_ + margin);
             ++j)
            for (std::int64_t i = std::max<std::int64_t>(0, west_ - margin);
                 i <= std::min(l_.columns - 1, west_ + side_ + margin); ++i) {
                const std::uint8_t kept = model_.levels[l_.at(i, j)];
                if (kept == kNeverNeeded || kept < entry.level) bound = std::max(bound, model_.errors_m[l_.at(i, j)]);
            }
        return bound;
    }

    void grow_box(ChunkEntry& entry, const std::vector<ChunkVertex>& vertices) const {
        const glm::dvec3 centre(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]);
        double half[3] = {0, 0, 0};
        const auto include = [&](const glm::dvec3& offset) {
            for (int a = 0; a < 3; ++a)
                half[a] = std::max(
                    half[a],
                    std::abs(glm::dot(offset, glm::dvec3(entry.axes[3 * a], entry.axes[3 * a + 1], entry.axes[3 * a + 2]))));
        };
        for (const ChunkVertex& v : vertices) include({v.x, v.y, v.z});
        // Posts left out lie within the error of triangles between vertices; the margin also covers the axes' rounding.
        const double margin = entry.above_m + entry.below_m + 1.0;
        for (int a = 0; a < 3; ++a) entry.half_extent_m[a] = static_cast<float>(half[a] * (1 + 1e-6) + margin);
    }

    void append_posts(std::vector<std::uint8_t>& payload) const {
        std::vector<float> heights;
        std::vector<std::uint8_t> classes;
        for (std::int64_t j = north_; j <= north_ + side_; ++j)
            for (std::int64_t i = west_; i <= west_ + side_; ++i) {
                const std::int64_t si = std::min<std::int64_t>(i, r_.columns - 1), sj = std::min<std::int64_t>(j, r_.rows - 1);
                const float height = r_.height_m[r_.at(static_cast<std::uint32_t>(si), static_cast<std::uint32_t>(sj))];
                heights.push_back(std::isnan(height) ? 0.0f : height);
                classes.push_back(static_cast<std::uint8_t>(l_.post_class[l_.at(i, j)]));
            }
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(heights.data());
        payload.insert(payload.end(), bytes, bytes + heights.size() * sizeof(float));
        payload.insert(payload.end(), classes.begin(), classes.end());
    }

    const TerrainModel& model_;
    const Lattice& l_;
    const Raster& r_;
    std::int64_t side_ = 0, west_ = 0, north_ = 0;
    double rounding_m_ = 0;
    ChunkMeshScratch scratch_{};
};

FileHeader make_header(const TerrainModel& model, const BuildOptions& options) {
    const Raster& r = model.raster;
    FileHeader h{};
    std::memcpy(h.magic, kTdbMagic, sizeof kTdbMagic);
    h.version = kTdbVersion;
    h.header_bytes = sizeof h;
    h.west_deg = r.west_deg;
    h.north_deg = r.north_deg;
    h.step_lon_deg = r.step_lon_deg;
    h.step_lat_deg = r.step_lat_deg;
    h.columns = r.columns;
    h.rows = r.rows;
    h.levels = model.lattice.levels;
    std::copy(model.tolerance_m.begin(), model.tolerance_m.end(), h.tolerance_m);
    h.min_height_m = std::numeric_limits<float>::max();
    h.max_height_m = std::numeric_limits<float>::lowest();
    for (const float height : r.height_m) {
        if (std::isnan(height)) continue;
        h.min_height_m = std::min(h.min_height_m, height);
        h.max_height_m = std::max(h.max_height_m, height);
    }
    h.le90_m = static_cast<float>(options.le90_m);
    h.void_posts = static_cast<std::uint32_t>(r.void_posts);
    h.undulation_west_deg = model.undulation_west_deg;
    h.undulation_north_deg = model.undulation_north_deg;
    h.undulation_step_deg = kUndulationStep_deg;
    h.undulation_columns = model.undulation_columns;
    h.undulation_rows = model.undulation_rows;
    std::strncpy(h.source, r.source.c_str(), sizeof h.source - 1);
    std::strncpy(h.vertical_datum, options.vertical_datum == VerticalDatum::egm96 ? "egm96" : "ellipsoid",
                 sizeof h.vertical_datum - 1);
    return h;
}

}  // namespace

TerrainModel make_model(Raster raster, const BuildOptions& options) {
    TerrainModel model;
    model.raster = std::move(raster);
    cut_geoid(model);
    for (std::uint32_t levels = useful_levels(model.raster);; --levels) {
        size_lattice(model, levels);
        fill_lattice(model);
        model.errors_m = measure_errors(model.lattice, [&options] {
            if (options.progress) options.progress(0, 1);
        });
        // Many voids need their borders at every level; then the coarsest levels are left away.
        if (fit_tolerances(model) || levels == 1) return model;
    }
}

std::vector<std::uint8_t> make_tdb(const TerrainModel& model, const BuildOptions& options) {
    FileHeader header = make_header(model, options);
    std::vector<ChunkEntry> entries;
    std::vector<std::vector<std::uint8_t>> payloads;
    ChunkWriter writer(model);
    const auto across = [](std::uint32_t posts, std::uint32_t level) {
        return (posts - 1 + (kChunkCells << level) - 1) / (kChunkCells << level);
    };
    for (std::uint32_t level = 0; level < header.levels; ++level)
        header.chunk_count += across(header.columns, level) * across(header.rows, level);
    for (std::uint32_t level = 0; level < header.levels; ++level)
        for (std::uint32_t j = 0; j < across(header.rows, level); ++j)
            for (std::uint32_t i = 0; i < across(header.columns, level); ++i) {
                entries.emplace_back();
                payloads.emplace_back();
                writer.write(level, i, j, entries.back(), payloads.back());
                header.max_chunk_vertices = std::max(header.max_chunk_vertices, entries.back().vertex_count);
                header.max_chunk_triangles = std::max(header.max_chunk_triangles, entries.back().triangle_count);
                if (options.progress) options.progress(entries.size(), header.chunk_count);
            }
    header.undulation_offset = sizeof header + entries.size() * sizeof(ChunkEntry);
    std::uint64_t offset = header.undulation_offset + model.undulation_m.size() * sizeof(float);
    for (std::size_t n = 0; n < entries.size(); ++n) {
        entries[n].offset = offset;
        offset += payloads[n].size();
    }
    header.file_bytes = offset;
    header.undulation_crc = base::crc32(model.undulation_m.data(), model.undulation_m.size() * sizeof(float));
    header.directory_crc = base::crc32(entries.data(), entries.size() * sizeof(ChunkEntry));
    header.header_crc = base::crc32(&header, offsetof(FileHeader, header_crc));

    std::vector<std::uint8_t> image;
    image.reserve(offset);
    const auto append = [&](const void* bytes, std::size_t count) {
        const auto* p = static_cast<const std::uint8_t*>(bytes);
        image.insert(image.end(), p, p + count);
    };
    append(&header, sizeof header);
    append(entries.data(), entries.size() * sizeof(ChunkEntry));
    append(model.undulation_m.data(), model.undulation_m.size() * sizeof(float));
    for (const auto& payload : payloads) append(payload.data(), payload.size());
    return image;
}

}  // namespace tedavis::host_sim
