#include "render_core/terrain/chunk_mesh.hpp"

#include <cstring>

#include "render_core/terrain/rtin.hpp"

namespace tedavis::terrain {
namespace {

constexpr std::uint16_t kEmpty = 0xFFFF;

/// Finds vertices of one chunk by lattice place and says which are in the mesh.
class VertexIndex {
public:
    VertexIndex(base::Span<const ChunkVertex> vertices, const ChunkPlace& place, ChunkMeshScratch& scratch)
        : vertices_(vertices),
          scratch_(scratch),
          side_(std::int64_t{kChunkCells} << place.level),
          west_(place.i * side_),
          north_(place.j * side_) {
        std::memset(scratch_.table, 0xFF, sizeof scratch_.table);
        for (std::uint32_t n = 0; n < vertices_.size(); ++n) insert(static_cast<std::uint16_t>(n));
    }

    [[nodiscard]] std::uint16_t find(LatticeVertex v) const {
        const std::int64_t i = v.i - west_, j = v.j - north_;
        for (std::uint32_t slot = slot_of(i, j);; slot = (slot + 1) & (ChunkMeshScratch::kTableSize - 1)) {
            const std::uint16_t n = scratch_.table[slot];
            if (n == kEmpty || (vertices_[n].i == i && vertices_[n].j == j)) return n;
        }
    }
    /// The index when the vertex is in the mesh, else kEmpty.
    [[nodiscard]] std::uint16_t find_effective(LatticeVertex v) const {
        const std::uint16_t n = find(v);
        return n != kEmpty && scratch_.effective[n] != 0 ? n : kEmpty;
    }
    [[nodiscard]] bool contains(LatticeVertex v) const {
        return v.i >= west_ && v.j >= north_ && v.i <= west_ + side_ && v.j <= north_ + side_;
    }
    [[nodiscard]] LatticeVertex place_of(const ChunkVertex& v) const { return {west_ + v.i, north_ + v.j}; }
    [[nodiscard]] std::int64_t side() const { return side_; }
    [[nodiscard]] std::int64_t west() const { return west_; }
    [[nodiscard]] std::int64_t north() const { return north_; }
    [[nodiscard]] const ChunkVertex& vertex(std::uint16_t n) const { return vertices_[n]; }

private:
    [[nodiscard]] static std::uint32_t slot_of(std::int64_t i, std::int64_t j) {
        const auto key = static_cast<std::uint32_t>((j << 16) | i);
        return (key * 0x9E3779B1u) >> 18;  // 14 bits
    }
    void insert(std::uint16_t n) {
        std::uint32_t slot = slot_of(vertices_[n].i, vertices_[n].j);
        while (scratch_.table[slot] != kEmpty) slot = (slot + 1) & (ChunkMeshScratch::kTableSize - 1);
        scratch_.table[slot] = n;
    }

    base::Span<const ChunkVertex> vertices_;
    ChunkMeshScratch& scratch_;
    std::int64_t side_, west_, north_;
};

std::uint8_t edges_of(const ChunkVertex& v, std::int64_t side) {
    return static_cast<std::uint8_t>((v.j == 0 ? kEdgeNorth : 0) | (v.i == side ? kEdgeEast : 0) |
                                     (v.j == side ? kEdgeSouth : 0) | (v.i == 0 ? kEdgeWest : 0));
}

bool is_corner(std::uint8_t edges) { return (edges & (edges - 1)) != 0; }

bool parent_effective(const VertexIndex& index, LatticeVertex parent) {
    return !index.contains(parent) || index.find_effective(parent) != kEmpty;
}

/// Coarse scales come first in file order, so parents are decided before their children.
void mark_effective(base::Span<const ChunkVertex> vertices, const ChunkPlace& place, std::uint8_t coarser_edges,
                    const VertexIndex& index, ChunkMeshScratch& scratch) {
    for (std::uint32_t n = 0; n < vertices.size(); ++n) {
        const ChunkVertex& v = vertices[n];
        const std::uint8_t edges = edges_of(v, index.side());
        bool effective = true;
        if (is_corner(edges)) {
            effective = true;
        } else if (edges != 0) {
            effective = (edges & coarser_edges) == 0 || v.top_level() > place.level;
        } else {
            const VertexParents parents = parents_of(index.place_of(v));
            effective = parent_effective(index, parents.first) && parent_effective(index, parents.second);
        }
        scratch.effective[n] = effective ? 1 : 0;
    }
}

class TriangleWriter {
public:
    TriangleWriter(const VertexIndex& index, const ChunkPlace& place, base::Span<std::uint16_t> out)
        : index_(index), place_(place), out_(out) {}

    [[nodiscard]] bool write(const LatticeTriangle& t) {
        if (beyond_raster(t)) return true;
        return t.is_unit() ? write_unit(t) : write_large(t);
    }
    [[nodiscard]] std::uint32_t count() const { return count_; }

private:
    [[nodiscard]] bool beyond_raster(const LatticeTriangle& t) const {
        const auto min3 = [](std::int64_t a, std::int64_t b, std::int64_t c) {
            return a < b ? (a < c ? a : c) : (b < c ? b : c);
        };
        return min3(t.a.i, t.b.i, t.c.i) >= place_.last_column || min3(t.a.j, t.b.j, t.c.j) >= place_.last_row;
    }
    [[nodiscard]] bool is_void(LatticeVertex v) const {
        const std::uint16_t n = index_.find(v);
        return n != kEmpty && index_.vertex(n).post_class() == PostClass::void_;
    }
    /// A large triangle is void throughout or not at all (the builder splits every mixed one).
    [[nodiscard]] bool write_large(const LatticeTriangle& t) { return is_void(t.c) || emit(t.a, t.b, t.c); }

    [[nodiscard]] bool write_unit(const LatticeTriangle& t) {
        const LatticeVertex opposite{t.a.i + t.b.i - t.c.i, t.a.j + t.b.j - t.c.j};
        if (is_void(t.a) || is_void(t.b) || is_void(t.c) || is_void(opposite)) return true;
        const std::int64_t i = t.a.i < t.b.i ? t.a.i : t.b.i, j = t.a.j < t.b.j ? t.a.j : t.b.j;
        const bool alternate_diagonal = ((i + j) & 1) == 0;
        if (!alternate_diagonal || index_.find_effective(opposite) == kEmpty) return emit(t.a, t.b, t.c);
        const bool north_east = t.c.i > i;
        return north_east ? emit({i, j}, {i, j + 1}, {i + 1, j}) : emit({i + 1, j}, {i, j + 1}, {i + 1, j + 1});
    }
    [[nodiscard]] bool emit(LatticeVertex a, LatticeVertex b, LatticeVertex c) {
        const std::uint16_t corners[3] = {index_.find_effective(a), index_.find_effective(b), index_.find_effective(c)};
        if (count_ + 3 > out_.size()) return false;
        for (const std::uint16_t corner : corners) {
            if (corner == kEmpty) return false;
            out_[count_++] = corner;
        }
        return true;
    }

    const VertexIndex& index_;
    const ChunkPlace& place_;
    base::Span<std::uint16_t> out_;
    std::uint32_t count_ = 0;
};

}  // namespace

MeshCount build_chunk_indices(base::Span<const ChunkVertex> vertices, const ChunkPlace& place, std::uint8_t coarser_edges,
                              ChunkMeshScratch& scratch, base::Span<std::uint16_t> indices) {
    if (vertices.size() > kMaxChunkVertices || place.level >= kMaxLevels) return {};
    const VertexIndex index(vertices, place, scratch);
    mark_effective(vertices, place, coarser_edges, index, scratch);

    // Depth of the network is two splits a scale; each split leaves one half waiting.
    LatticeTriangle open[2 * (6 + kMaxLevels) + 4];
    std::uint32_t waiting = 0;
    open[waiting++] = square_triangle(index.west(), index.north(), index.side(), true);
    open[waiting++] = square_triangle(index.west(), index.north(), index.side(), false);
    TriangleWriter writer(index, place, indices);
    while (waiting > 0) {
        const LatticeTriangle t = open[--waiting];
        if (!t.is_unit() && index.find_effective(t.middle()) != kEmpty) {
            open[waiting++] = t.half_at_b();
            open[waiting++] = t.half_at_a();
        } else if (!writer.write(t)) {
            return {};
        }
    }
    return {writer.count(), true};
}

}  // namespace tedavis::terrain
