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

/// Length of the normal of what is not shaded; it still says how the surface lies. Below half, by which shaders tell.
inline constexpr double kUnshaded = 0.4;

struct SolidVertex {
    glm::vec3 place_m{0};  ///< ECEF minus the piece's anchor
    /// Normal in ECEF, -1..1 as 0..254; one of kUnshaded or none leaves the colour as it is.
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
    /// Of near_m; what is opaque ends at once, at kOpaqueFrom.
    static constexpr float kWholeFrom = 4, kOpaqueFrom = 2;
    float opacity = 1;    ///< below 1, or with a vertex colour's alpha below 255: mixed with what is behind
    float ghost = 0;      ///< what terrain before it leaves of the opacity
    float halo_px = 0;    ///< the piece is the rim of others: swollen along its normals by so many pixels, drawn inside out
    float raised_px = 0;  ///< along its normals: of what lies on the ground, which is drawn a little above or below the true one
    SolidFading fading = SolidFading::none;
    bool has_grid = false;      ///< the surface grid's lines, where the frame has one
    float fading_strength = 0;  ///< 0..1: what the least sure loses
    float fading_levels = 0;    ///< gradations; 0 for continuous
    float growth_per_hour = 0;  ///< of the uncertainty, by the data's age
    float near_m = 0;  ///< nothing nearer to the eye is seen; what is mixed is whole from kWholeFrom times as far on; 0: all is
    std::uint8_t group = 0;  ///< below 32: what is hidden and shown together
    bool is_mixed = false;   ///< has colours that are not opaque
    bool is_hollow = false;  ///< not seen from inside: its far sides do not show through its near ones
    bool is_thing = true;    ///< casts a shadow; false for margins, hulls of what is unsure, and cues
};
[[nodiscard]] bool operator==(const SolidLook& a, const SolidLook& b) noexcept;

struct SolidPiece {
    glm::dvec3 anchor{0};  ///< ECEF, m
    SolidLook look;
    std::int64_t data_time_ns = 0;  ///< uncertainty grows from there
    float radius_m = 0;             ///< nothing is farther from the anchor
    float top_m = 0;                ///< nor higher over the ellipsoid
    std::uint32_t first_vertex = 0, vertices = 0;
    std::uint32_t first_index = 0, indices = 0;
};

/// Room of a batch, and of buffers that hold a copy of it.
struct SolidRoom {
    std::uint32_t vertices = 0, indices = 0, pieces = 0;

    [[nodiscard]] std::uint64_t gpu_bytes() const {
        return std::uint64_t{vertices} * sizeof(SolidVertex) + std::uint64_t{indices} * sizeof(std::uint16_t);
    }
    [[nodiscard]] std::uint64_t cpu_bytes() const { return gpu_bytes() + std::uint64_t{pieces} * sizeof(SolidPiece); }
};

class SolidBatch {
public:
    /// More vertices would not be told apart by 16 bits, of which one value is left for a restart.
    static constexpr std::uint32_t kMaxPieceVertices = 65535;
    /// A vertex farther from its anchor begins a piece of its own.
    static constexpr double kFarthestFromAnchor_m = 30'000;

    SolidBatch() = default;
    SolidBatch(base::Span<SolidVertex> vertices, base::Span<std::uint16_t> indices, base::Span<SolidPiece> pieces);
    /// With this room from an arena; what the arena does not hold is no room.
    SolidBatch(base::Arena& memory, const SolidRoom& room);

    /// Empties the batch; counters of refusals stay.
    void clear();
    /// What follows looks like this.
    void set_look(const SolidLook& look, std::int64_t data_time_ns);
    /// A mesh round `origin` (ECEF): places of its vertices are from there, indices from its first vertex. False, and nothing is
    /// added, when it does not fit.
    bool add(const glm::dvec3& origin, base::Span<const SolidVertex> vertices, base::Span<const std::uint16_t> indices);

    [[nodiscard]] base::Span<const SolidVertex> vertices() const { return {vertices_.data(), vertex_count_}; }
    [[nodiscard]] base::Span<const std::uint16_t> indices() const { return {indices_.data(), index_count_}; }
    [[nodiscard]] base::Span<const SolidPiece> pieces() const { return {pieces_.data(), piece_count_}; }
    [[nodiscard]] std::size_t vertices_left() const { return vertices_.size() - vertex_count_; }
    [[nodiscard]] std::size_t indices_left() const { return indices_.size() - index_count_; }
    /// In vertices.
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
