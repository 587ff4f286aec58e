#include "host_sim/terrain_builder/make_chunk.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/user_error.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr double kFinestQuantum_m = 1.0 / 1024;
constexpr double kReachOfHeights_m = 5000;  // half the range of heights that a raster may hold

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

/// Makes one chunk.
class ChunkMaker {
public:
    ChunkMaker(const TerrainModel& model, ChunkMeshScratch& scratch)
        : model_(model), l_(model.lattice), r_(model.raster), scratch_(scratch) {}

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
            {base::radians(post_latitude_deg(r_, j)), base::radians(post_longitude_deg(r_, i)), {l_.surface_m[l_.at(i, j)]}});
    }

    void place_box(ChunkEntry& entry) {
        const double latitude = base::radians(post_latitude_deg(r_, north_ + side_ / 2)),
                     longitude = base::radians(post_longitude_deg(r_, west_ + side_ / 2));
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
        const glm::dmat3 axes =
            earth::north_east_down(base::radians(post_latitude_deg(r_, j)), base::radians(post_longitude_deg(r_, i)));
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
    ChunkMeshScratch& scratch_;
};

}  // namespace

MadeChunk make_chunk(const TerrainModel& model, std::uint32_t level, std::uint32_t i, std::uint32_t j,
                     ChunkMeshScratch& scratch) {
    MadeChunk made;
    ChunkMaker(model, scratch).write(level, i, j, made.entry, made.payload);
    return made;
}

}  // namespace tedavis::host_sim
