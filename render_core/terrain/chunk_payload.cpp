#include "render_core/terrain/chunk_payload.hpp"

#include <cmath>

#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::terrain {
namespace {

constexpr std::uint8_t kKnownKindBits = 7;
constexpr double kHighest_m = 12000;

/// Of the domain in posts; its sides are numbered along the border from the north-west corner.
struct Extent {
    std::uint32_t i = 0, j = 0;

    [[nodiscard]] std::uint32_t perimeter() const { return 2 * (i + j); }
    [[nodiscard]] bool is_on_border(const ChunkVertex& v) const { return v.i == 0 || v.j == 0 || v.i == i || v.j == j; }
    [[nodiscard]] bool is_corner(const ChunkVertex& v) const { return (v.i == 0 || v.i == i) && (v.j == 0 || v.j == j); }
    /// Posts from the north-west corner, clockwise; the vertex must be on the border.
    [[nodiscard]] std::uint32_t along_border(const ChunkVertex& v) const {
        if (v.j == 0) return v.i;
        if (v.i == i) return i + v.j;
        if (v.j == j) return i + j + (i - v.i);
        return 2 * i + j + (j - v.j);
    }
};

// Comparisons are written so that NaN fails them.
bool lies_in_box(const ChunkVertex& v, const ChunkEntry& entry) {
    for (int a = 0; a < 3; ++a) {
        const float* axis = entry.axes + 3 * a;
        const double along = double{v.x} * axis[0] + double{v.y} * axis[1] + double{v.z} * axis[2];
        const double margin_m = 1 + 1e-3 * double{entry.half_extent_m[a]};  // axes are floats
        if (!(std::abs(along) <= entry.half_extent_m[a] + margin_m)) return false;
    }
    return std::abs(v.height_m) <= kHighest_m;
}

bool vertex_holds(const ChunkVertex& v, const ChunkEntry& entry, const Extent& extent) {
    return v.i <= extent.i && v.j <= extent.j && (v.kind & ~kKnownKindBits) == 0 && v.post_class() != PostClass::outside &&
           lies_in_box(v, entry);
}

/// Clockwise without a step back, all corners in it.
bool border_holds(base::Span<const ChunkVertex> border, const Extent& extent) {
    std::uint32_t corners = 0, previous = 0;
    for (std::size_t n = 0; n < border.size(); ++n) {
        const ChunkVertex& v = border[n];
        if (!extent.is_on_border(v)) return false;
        const std::uint32_t along = extent.along_border(v);
        if (n == 0 ? along != 0 : along <= previous) return false;
        previous = along;
        if (extent.is_corner(v)) {
            if (!v.stays_beside_coarser()) return false;
            ++corners;
        }
    }
    return corners == 4;
}

bool grid_holds(base::Span<const ChunkVertex> vertices, const Extent& extent, std::uint32_t level) {
    const RegularGrid grid = regular_grid(extent.i, extent.j, level);
    for (std::uint32_t b = 0; b < grid.rows; ++b)
        for (std::uint32_t a = 0; a < grid.columns; ++a) {
            const ChunkVertex& v = vertices[grid.index_of(a, b)];
            if (v.i != regular_post(a, extent.i, level) || v.j != regular_post(b, extent.j, level)) return false;
        }
    return true;
}

/// Twice the area in lattice coordinates; positive for a counter-clockwise triangle seen from above (j runs south).
std::int64_t doubled_area(const ChunkVertex& a, const ChunkVertex& b, const ChunkVertex& c) {
    const std::int64_t bi = std::int64_t{b.i} - a.i, bj = std::int64_t{b.j} - a.j;
    const std::int64_t ci = std::int64_t{c.i} - a.i, cj = std::int64_t{c.j} - a.j;
    return ci * bj - bi * cj;
}

/// Every triangle is turned the right way, strips come first, and together they have the area of the domain.
bool triangles_hold(base::Span<const ChunkVertex> vertices, base::Span<const std::uint16_t> indices, const ChunkEntry& entry,
                    const Extent& extent) {
    std::int64_t area = 0;
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        bool touches_strip = false;
        for (std::size_t corner = n; corner < n + 3; ++corner) {
            if (indices[corner] >= vertices.size()) return false;
            touches_strip =
                touches_strip || (indices[corner] < entry.border_count && !vertices[indices[corner]].stays_beside_coarser());
        }
        const std::int64_t part = doubled_area(vertices[indices[n]], vertices[indices[n + 1]], vertices[indices[n + 2]]);
        if (part <= 0 || touches_strip != (n / 3 < entry.strip_count)) return false;
        area += part;
    }
    return area == 2 * std::int64_t{extent.i} * extent.j;
}

}  // namespace

base::Span<const ChunkVertex> payload_vertices(const ChunkEntry& entry, base::Span<const std::uint8_t> bytes) {
    TEDAVIS_CHECK(bytes.size() >= entry.payload.bytes);
    return {reinterpret_cast<const ChunkVertex*>(bytes.data()), entry.vertex_count};
}

base::Span<const std::uint16_t> payload_indices(const ChunkEntry& entry, base::Span<const std::uint8_t> bytes) {
    TEDAVIS_CHECK(bytes.size() >= entry.payload.bytes);
    if ((entry.flags & kChunkRegular) != 0) return {};
    return {reinterpret_cast<const std::uint16_t*>(bytes.data() + entry.vertex_count * sizeof(ChunkVertex)),
            std::size_t{entry.triangle_count} * 3};
}

bool payload_holds(const Lattice& lattice, const ChunkEntry& entry, base::Span<const std::uint8_t> bytes) {
    const PostRange posts = lattice.posts_of(key_of(entry));
    const Extent extent{posts.i1 - posts.i0, posts.j1 - posts.j0};
    const base::Span<const ChunkVertex> vertices = payload_vertices(entry, bytes);
    for (const ChunkVertex& v : vertices)
        if (!vertex_holds(v, entry, extent)) return false;
    if (!border_holds(vertices.subspan(0, entry.border_count), extent)) return false;
    for (std::size_t n = entry.border_count; n < vertices.size(); ++n)
        if (extent.is_on_border(vertices[n]) || vertices[n].stays_beside_coarser()) return false;
    if ((entry.flags & kChunkRegular) != 0) return grid_holds(vertices, extent, entry.level);
    return triangles_hold(vertices, payload_indices(entry, bytes), entry, extent);
}

}  // namespace tedavis::terrain
