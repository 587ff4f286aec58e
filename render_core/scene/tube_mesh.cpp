#include "render_core/scene/tube_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::scene {
namespace {

/// Directions across a ring: of sides, and of the corners before them.
struct Rose {
    struct Direction {
        double along_normal, along_binormal;

        [[nodiscard]] glm::dvec3 of(const TubeFrame& frame) const {
            return along_normal * frame.normal + along_binormal * frame.binormal();
        }
    };
    std::uint32_t sides;
    Direction side[kMaxTubeSides], corner[kMaxTubeSides];

    explicit Rose(std::uint32_t count) : sides(count), side{}, corner{} {
        for (std::uint32_t n = 0; n < sides; ++n) {
            const double turn = 2 * base::kPi * n / sides, half = base::kPi / sides;
            side[n] = {std::cos(turn), std::sin(turn)};
            corner[n] = {std::cos(turn - half), std::sin(turn - half)};
        }
    }
};

struct Amount {
    std::uint32_t vertices, indices;
};

class TubeMesher {
public:
    TubeMesher(std::uint32_t sides, const glm::dvec3& origin, const TubeMeshOutput& output, std::uint32_t chunk_vertices)
        : rose_(sides),
          origin_(origin),
          out_(output),
          ring_{2 * sides, 0},
          end_{sides, 3 * (sides - 2)},
          walls_{0, 6 * sides},
          chunk_vertices_(std::clamp(chunk_vertices, 2 * (ring_.vertices + end_.vertices), kMaxChunkVertices)) {}

    /// The first rings of a piece, between two ends.
    [[nodiscard]] bool begin(const TubeRing& first, const TubeRing& second) {
        const Amount needed{2 * (ring_.vertices + end_.vertices), walls_.indices + 2 * end_.indices};
        if (!fits(needed) && !open_chunk(needed)) return false;
        add_end(first, -1);
        last_ring_ = add_ring(first);
        add_walls(second);
        return true;
    }

    [[nodiscard]] bool go_on(const TubeRing& before, const TubeRing& next) {
        const Amount needed{ring_.vertices + end_.vertices, walls_.indices + end_.indices};
        if (!fits(needed)) {
            // The end of the tube so far has its room, which then stays empty.
            if (!open_chunk({needed.vertices + ring_.vertices, needed.indices})) return false;
            last_ring_ = add_ring(before);
        }
        add_walls(next);
        return true;
    }

    void end(const TubeRing& last) { add_end(last, 1); }

    [[nodiscard]] TubeMeshCounts counts() const { return counts_; }

private:
    [[nodiscard]] bool fits_output(const Amount& needed) const {
        return out_.vertices.size() - counts_.vertices >= needed.vertices &&
               out_.indices.size() - counts_.indices >= needed.indices;
    }
    [[nodiscard]] bool fits(const Amount& needed) const {
        return counts_.chunks > 0 && chunk().vertices + needed.vertices <= chunk_vertices_ && fits_output(needed);
    }
    [[nodiscard]] bool open_chunk(const Amount& needed) {
        if (counts_.chunks == out_.chunks.size() || !fits_output(needed)) return false;
        out_.chunks[counts_.chunks++] = {counts_.vertices, 0, counts_.indices, 0};
        return true;
    }
    [[nodiscard]] TubeChunk& chunk() const { return out_.chunks[counts_.chunks - 1]; }

    void add_vertex(const glm::dvec3& place, const glm::dvec3& normal, std::uint32_t source, std::uint8_t side) {
        out_.vertices[counts_.vertices++] = {glm::vec3(place - origin_), glm::vec3(normal), source, side};
        ++chunk().vertices;
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const std::uint32_t index : {a, b, c}) out_.indices[counts_.indices++] = static_cast<std::uint16_t>(index);
        chunk().indices += 3;
    }

    [[nodiscard]] glm::dvec3 corner(const TubeRing& ring, std::uint32_t n) const {
        return ring.centre + static_cast<double>(ring.radius_m) * rose_.corner[n % rose_.sides].of(ring.frame);
    }

    /// Returns its first vertex in the chunk; each side has two.
    std::uint32_t add_ring(const TubeRing& ring) {
        const std::uint32_t first = chunk().vertices;
        for (std::uint32_t n = 0; n < rose_.sides; ++n)
            for (std::uint32_t corner_of_side = n; corner_of_side <= n + 1; ++corner_of_side)
                add_vertex(corner(ring, corner_of_side), rose_.side[n].of(ring.frame), ring.source, static_cast<std::uint8_t>(n));
        return first;
    }

    void add_walls(const TubeRing& ring) {
        const std::uint32_t before = last_ring_;
        last_ring_ = add_ring(ring);
        for (std::uint32_t n = 0; n < 2 * rose_.sides; n += 2) {
            add_triangle(before + n, before + n + 1, last_ring_ + n + 1);
            add_triangle(before + n, last_ring_ + n + 1, last_ring_ + n);
        }
    }

    /// A fan across the tube; `facing` 1 along the tangent, -1 against it.
    void add_end(const TubeRing& ring, int facing) {
        const std::uint32_t first = chunk().vertices;
        for (std::uint32_t n = 0; n < rose_.sides; ++n)
            add_vertex(corner(ring, facing > 0 ? n : rose_.sides - n), static_cast<double>(facing) * ring.frame.tangent,
                       ring.source, kTubeEndSide);
        for (std::uint32_t n = 1; n + 1 < rose_.sides; ++n) add_triangle(first, first + n, first + n + 1);
    }

    const Rose rose_;
    const glm::dvec3 origin_;
    const TubeMeshOutput out_;
    const Amount ring_, end_, walls_;
    const std::uint32_t chunk_vertices_;
    TubeMeshCounts counts_;
    std::uint32_t last_ring_ = 0;  ///< its first vertex in the chunk
};

std::size_t end_of_piece(base::Span<const TubeRing> rings, std::size_t first) {
    std::size_t end = first + 1;
    while (end < rings.size() && rings[end].piece == rings[first].piece) ++end;
    return end;
}

/// How many of its rings have found room.
std::size_t mesh_piece(base::Span<const TubeRing> piece, TubeMesher& mesher) {
    if (!mesher.begin(piece[0], piece[1])) return 0;
    std::size_t n = 2;
    while (n < piece.size() && mesher.go_on(piece[n - 1], piece[n])) ++n;
    mesher.end(piece[n - 1]);
    return n;
}

}  // namespace

TubeMeshCounts mesh_tube(base::Span<const TubeRing> rings, std::uint32_t sides, const glm::dvec3& origin,
                         const TubeMeshOutput& output, std::uint32_t chunk_vertices) noexcept {
    TubeMesher mesher(std::clamp(sides, kMinTubeSides, kMaxTubeSides), origin, output, chunk_vertices);
    std::uint32_t meshed = 0, left_out = 0;
    for (std::size_t first = 0, end = 0; first < rings.size(); first = end) {
        end = end_of_piece(rings, first);
        if (end - first < 2) continue;
        const std::size_t found_room = left_out > 0 ? 0 : mesh_piece(rings.subspan(first, end - first), mesher);
        meshed += static_cast<std::uint32_t>(found_room);
        left_out += static_cast<std::uint32_t>(end - first - found_room);
    }
    TubeMeshCounts counts = mesher.counts();
    counts.rings = meshed;
    counts.rings_left_out = left_out;
    return counts;
}

}  // namespace tedavis::scene
