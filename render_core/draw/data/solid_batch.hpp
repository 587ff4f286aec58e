/// Collects the surfaces of spatial data as triangles in space: tubes, prisms, obstacles, runways, isosurfaces. No GL:
/// solid_drawer.hpp draws it, tests read it.
///
/// Triangles are counter-clockwise seen from outside. A piece is drawn by one call: its vertices lie round an anchor, so that
/// floats hold them, and it has one look.
///
/// Thread    one. Memory  the caller's. Failure  what does not fit is left out whole and counted in `use().refused`.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/resource_use.hpp"
#include "render_core/base/span.hpp"
#include "render_core/design/color.hpp"
#include "render_core/scene/uncertainty.hpp"

namespace tedavis::draw {

/// Number of batches that are drawn together: static solids, and moving ones.
inline constexpr std::size_t kMaxSolidBuffers = 2;

/// Length of the normal of unshaded surfaces, which still gives the surface's orientation. It is below 0.5, by which shaders
/// recognise it.
inline constexpr double kUnshaded = 0.4;

struct SolidVertex {
    glm::vec3 place_m{0};  ///< ECEF minus the piece's anchor
    /// Normal in ECEF, -1..1 as 0..254; a length of kUnshaded or 0 means unshaded.
    std::uint8_t normal[3] = {127, 127, 127};
    std::uint8_t uncertainty = 0;  ///< scene::Uncertainty::code
    std::uint8_t rgba[4] = {};
};
static_assert(sizeof(SolidVertex) == 20);

[[nodiscard]] SolidVertex solid_vertex(const glm::vec3& place_m, const glm::vec3& normal, design::Color color,
                                       scene::Uncertainty uncertainty = scene::Uncertainty::from_code(0));

/// How uncertainty changes the colour of a piece.
enum class SolidFading : std::uint8_t { none, transparency, saturation };

struct SolidLook {
    static constexpr float kNearestShare = 0.06f;
    /// Multiples of near_m; opaque pieces are cut at kOpaqueFrom.
    static constexpr float kWholeFrom = 4, kOpaqueFrom = 2;
    float opacity = 1;    ///< below 1, or with a vertex alpha below 255: blended
    float ghost = 0;      ///< share of the opacity that remains behind terrain
    float halo_px = 0;    ///< above 0: a rim, enlarged along its normals by this many pixels; only its back faces are drawn
    float raised_px = 0;  ///< offset along its normals, for pieces on the ground
    SolidFading fading = SolidFading::none;
    bool has_grid = false;      ///< the surface grid's lines, where the frame has one
    float fading_strength = 0;  ///< 0..1: effect on the least certain
    float fading_levels = 0;    ///< gradations; 0 for continuous
    float growth_per_hour = 0;  ///< growth of the uncertainty by the data's age
    float near_m = 0;           ///< nothing nearer is drawn; blended pieces fade in up to kWholeFrom times near_m; 0: no limit
    std::uint8_t group = 0;     ///< below 32: pieces of a group are shown and hidden together
    bool is_mixed = false;      ///< has colours that are not opaque
    bool is_hollow = false;     ///< far sides do not show through near ones
    float nearer_m = 0;         ///< depths are drawn nearer to the eye by this, at most by kNearestShare of the distance
    bool is_last = false;       ///< on the ground and drawn over all other solids, from its first triangle to its last
    bool is_thing = true;       ///< an object that casts a shadow; false for margins, uncertainty hulls and cues
};
[[nodiscard]] bool operator==(const SolidLook& a, const SolidLook& b) noexcept;

struct SolidPiece {
    glm::dvec3 anchor{0};  ///< ECEF, m
    SolidLook look;
    std::int64_t data_time_ns = 0;  ///< the time from which the uncertainty grows
    float radius_m = 0;             ///< radius round the anchor that contains the piece
    float top_m = 0;                ///< greatest height above the ellipsoid
    std::uint32_t first_vertex = 0, vertices = 0;
    std::uint32_t first_index = 0, indices = 0;
};

/// Capacity of a batch, and of buffers that hold a copy of it.
struct SolidRoom {
    std::uint32_t vertices = 0, indices = 0, pieces = 0;

    [[nodiscard]] std::uint64_t gpu_bytes() const {
        return std::uint64_t{vertices} * sizeof(SolidVertex) + std::uint64_t{indices} * sizeof(std::uint16_t);
    }
    [[nodiscard]] std::uint64_t cpu_bytes() const { return gpu_bytes() + std::uint64_t{pieces} * sizeof(SolidPiece); }
};

class SolidBatch {
public:
    /// Limit of 16-bit indices; one value is reserved for primitive restart.
    static constexpr std::uint32_t kMaxPieceVertices = 65535;
    /// A mesh with a vertex farther from the anchor begins a new piece.
    static constexpr double kFarthestFromAnchor_m = 30'000;

    SolidBatch() = default;
    SolidBatch(base::Span<SolidVertex> vertices, base::Span<std::uint16_t> indices, base::Span<SolidPiece> pieces);
    /// Allocates this capacity from an arena, or less where the arena is too small.
    SolidBatch(base::Arena& memory, const SolidRoom& room);

    /// Empties the batch; counters of refusals stay.
    void clear();
    /// Sets the look of the meshes added next.
    void set_look(const SolidLook& look, std::int64_t data_time_ns);
    /// Adds a mesh round `origin` (ECEF): positions are relative to it, indices to its first vertex. Returns false, and adds
    /// nothing, when it does not fit.
    bool add(const glm::dvec3& origin, base::Span<const SolidVertex> vertices, base::Span<const std::uint16_t> indices);

    [[nodiscard]] base::Span<const SolidVertex> vertices() const { return {vertices_.data(), vertex_count_}; }
    [[nodiscard]] base::Span<const std::uint16_t> indices() const { return {indices_.data(), index_count_}; }
    [[nodiscard]] base::Span<const SolidPiece> pieces() const { return {pieces_.data(), piece_count_}; }
    [[nodiscard]] std::size_t vertices_left() const { return vertices_.size() - vertex_count_; }
    [[nodiscard]] std::size_t indices_left() const { return indices_.size() - index_count_; }
    /// Capacity and use are counted in vertices.
    [[nodiscard]] const base::ResourceUse& use() const { return use_; }

private:
    [[nodiscard]] bool has_room(std::size_t vertices, std::size_t indices) const;
    [[nodiscard]] bool goes_on(const glm::dvec3& origin, std::size_t vertices) const;

    base::Span<SolidVertex> vertices_;
    base::Span<std::uint16_t> indices_;
    base::Span<SolidPiece> pieces_;
    std::size_t vertex_count_ = 0, index_count_ = 0, piece_count_ = 0;
    SolidLook look_;
    std::int64_t data_time_ns_ = 0;
    bool begins_piece_ = true;
    base::ResourceUse use_;
};

}  // namespace tedavis::draw
