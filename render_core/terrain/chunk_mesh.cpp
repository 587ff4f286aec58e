#include "render_core/terrain/chunk_mesh.hpp"

#include "render_core/terrain/stored_triangles.hpp"

namespace tedavis::terrain {
namespace {

struct Corners {
    std::uint16_t a, b, c;
};

/// Twice the area over the lattice; positive when counter-clockwise seen from above.
std::int64_t twice_area(const ChunkVertex& a, const ChunkVertex& b, const ChunkVertex& c) {
    const std::int64_t bi = std::int64_t{b.i} - a.i, bj = std::int64_t{b.j} - a.j;
    const std::int64_t ci = std::int64_t{c.i} - a.i, cj = std::int64_t{c.j} - a.j;
    return bj * ci - bi * cj;
}

std::int64_t squared_length(const ChunkVertex& a, const ChunkVertex& b) {
    const std::int64_t di = std::int64_t{b.i} - a.i, dj = std::int64_t{b.j} - a.j;
    return di * di + dj * dj;
}

bool same_place(const ChunkVertex& a, const ChunkVertex& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

class MeshBuilder {
public:
    MeshBuilder(const ChunkEntry& entry, base::Span<const ChunkVertex> vertices, ChunkMeshScratch& scratch,
                base::Span<std::uint16_t> out)
        : entry_(entry), vertices_(vertices), scratch_(scratch), out_(out) {}

    void mark_taken_out(std::uint8_t coarser_edges) {
        ChunkVertex south_east = vertices_[0];
        for (std::uint32_t n = 0; n < entry_.border_count; ++n) {
            if (vertices_[n].i > south_east.i) south_east.i = vertices_[n].i;
            if (vertices_[n].j > south_east.j) south_east.j = vertices_[n].j;
        }
        for (std::uint32_t n = 0; n < vertices_.size(); ++n) scratch_.taken_out[n] = 0;
        for (std::uint32_t n = 0; n < entry_.border_count; ++n)
            scratch_.taken_out[n] = is_taken_out(vertices_[n], south_east.i, south_east.j, coarser_edges) ? 1 : 0;
    }

    /// Triangles that lose a corner wait in the strip.
    [[nodiscard]] bool add(const Corners& t) {
        if (t.a >= vertices_.size() || t.b >= vertices_.size() || t.c >= vertices_.size()) return false;
        const bool in_strip = scratch_.taken_out[t.a] != 0 || scratch_.taken_out[t.b] != 0 || scratch_.taken_out[t.c] != 0;
        return in_strip ? push_strip(t) : write(t);
    }

    [[nodiscard]] bool close_strip() {
        for (std::uint32_t n = 0; n < entry_.border_count; ++n)
            if (scratch_.taken_out[n] != 0 && !take_out(static_cast<std::uint16_t>(n))) return false;
        for (std::uint32_t n = 0; n < strip_; ++n)
            if (!write(strip_triangle(n))) return false;
        return true;
    }
    [[nodiscard]] std::uint32_t count() const { return count_; }

private:
    [[nodiscard]] bool write(const Corners& t) {
        const ChunkVertex &a = vertices_[t.a], &b = vertices_[t.b], &c = vertices_[t.c];
        if (same_place(a, b) || same_place(b, c) || same_place(c, a)) return true;
        if (count_ + 3 > out_.size()) return false;
        out_[count_++] = t.a;
        out_[count_++] = t.b;
        out_[count_++] = t.c;
        return true;
    }
    [[nodiscard]] bool push_strip(const Corners& t) {
        if (strip_ == kMaxChunkTriangles) return false;
        std::uint16_t* at = scratch_.strip + 3 * strip_++;
        at[0] = t.a;
        at[1] = t.b;
        at[2] = t.c;
        return true;
    }
    [[nodiscard]] Corners strip_triangle(std::uint32_t n) const {
        const std::uint16_t* at = scratch_.strip + 3 * n;
        return {at[0], at[1], at[2]};
    }
    void remove_strip(std::uint32_t n) {
        --strip_;
        for (std::uint32_t k = 0; k < 3; ++k) scratch_.strip[3 * n + k] = scratch_.strip[3 * strip_ + k];
    }

    [[nodiscard]] bool take_out(std::uint16_t v) { return gather_ring(v) && cut_ears(); }

    /// The vertices round `v`, from one side of the border to the other; its triangles leave the strip.
    [[nodiscard]] bool gather_ring(std::uint16_t v) {
        std::uint32_t sides = 0;
        Corners fan[ChunkMeshScratch::kMaxRing];  // `a` to `b` is the side away from v
        for (std::uint32_t n = strip_; n-- > 0;) {
            const Corners t = strip_triangle(n);
            if (t.a != v && t.b != v && t.c != v) continue;
            if (sides + 1 == ChunkMeshScratch::kMaxRing) return false;
            fan[sides++] = t.a == v ? Corners{t.b, t.c, v} : t.b == v ? Corners{t.c, t.a, v} : Corners{t.a, t.b, v};
            remove_strip(n);
        }
        return sides > 0 && chain(fan, sides);
    }

    /// Puts the sides of a fan one after the other into the ring.
    [[nodiscard]] bool chain(Corners (&fan)[ChunkMeshScratch::kMaxRing], std::uint32_t sides) {
        std::uint32_t first = 0;
        for (std::uint32_t n = 0; n < sides; ++n) {
            bool has_one_before = false;
            for (std::uint32_t m = 0; m < sides; ++m) has_one_before = has_one_before || fan[m].b == fan[n].a;
            if (!has_one_before) first = n;
        }
        ring_ = 0;
        scratch_.ring[ring_++] = fan[first].a;
        std::uint16_t end = fan[first].b;
        for (std::uint32_t linked = 0; linked < sides; ++linked) {
            scratch_.ring[ring_++] = end;
            std::uint32_t next = 0;
            while (next < sides && fan[next].a != end) ++next;
            if (next == sides) return linked + 1 == sides;  // a gap: the triangles round the vertex are no fan
            end = fan[next].b;
        }
        return false;  // a closed ring: the vertex is not on the border
    }

    [[nodiscard]] bool cut_ears() {
        while (ring_ > 2) {
            std::uint32_t best = ring_;
            std::int64_t shortest = INT64_MAX;
            for (std::uint32_t n = 0; n < ring_; ++n) {
                if (ring_ > 3 && !is_ear(n)) continue;
                const std::int64_t length = squared_length(at(n + ring_ - 1), at(n + 1));
                if (length >= shortest) continue;
                shortest = length;
                best = n;
            }
            if (best == ring_ || !push_ear(best)) return false;
        }
        return true;
    }
    [[nodiscard]] std::uint16_t ring_index(std::uint32_t n) const { return scratch_.ring[n % ring_]; }
    [[nodiscard]] const ChunkVertex& at(std::uint32_t n) const { return vertices_[ring_index(n)]; }

    [[nodiscard]] bool is_ear(std::uint32_t n) const {
        const ChunkVertex &a = at(n + ring_ - 1), &b = at(n), &c = at(n + 1);
        if (twice_area(a, b, c) <= 0) return false;
        for (std::uint32_t m = n + 2; m < n + ring_ - 1; ++m) {
            const ChunkVertex& p = at(m);
            if (twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0) return false;
        }
        return true;
    }
    [[nodiscard]] bool push_ear(std::uint32_t n) {
        const Corners t{ring_index(n + ring_ - 1), ring_index(n), ring_index(n + 1)};
        if (twice_area(vertices_[t.a], vertices_[t.b], vertices_[t.c]) <= 0 || !push_strip(t)) return false;
        for (std::uint32_t m = n % ring_; m + 1 < ring_; ++m) scratch_.ring[m] = scratch_.ring[m + 1];
        --ring_;
        return true;
    }

    const ChunkEntry& entry_;
    base::Span<const ChunkVertex> vertices_;
    ChunkMeshScratch& scratch_;
    base::Span<std::uint16_t> out_;
    std::uint32_t count_ = 0, strip_ = 0, ring_ = 0;
};

}  // namespace

bool is_taken_out(const ChunkVertex& v, std::uint32_t last_i, std::uint32_t last_j, std::uint8_t coarser_edges) {
    const auto sides = static_cast<std::uint8_t>((v.j == 0 ? kEdgeNorth : 0) | (v.i == last_i ? kEdgeEast : 0) |
                                                 (v.j == last_j ? kEdgeSouth : 0) | (v.i == 0 ? kEdgeWest : 0));
    const bool is_corner = (sides & (sides - 1)) != 0;
    return !is_corner && (sides & coarser_edges) != 0 && !v.stays_beside_coarser();
}

MeshCount build_chunk_indices(const ChunkEntry& entry, base::Span<const ChunkVertex> vertices,
                              base::Span<const std::uint16_t> stored, std::uint8_t coarser_edges, ChunkMeshScratch& scratch,
                              base::Span<std::uint16_t> indices) {
    if (vertices.size() < 4 || vertices.size() > kMaxChunkVertices || entry.vertex_count != vertices.size() ||
        entry.border_count > vertices.size())
        return {};
    MeshBuilder mesh(entry, vertices, scratch, indices);
    mesh.mark_taken_out(coarser_edges);
    const auto add = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) { return mesh.add({a, b, c}); };
    if (!each_stored_triangle(entry, vertices, stored, add) || !mesh.close_strip()) return {};
    return {mesh.count(), true};
}

}  // namespace tedavis::terrain
