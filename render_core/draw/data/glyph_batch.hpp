/// Collects the glyphs of a frame: instances of shapes, in runs of one shape. No GL: glyph_drawer draws it, tests read it.
///
/// Thread    one. Memory  the caller's. Failure  a run that does not fit is left out whole and counted in `use().refused`.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/resource_use.hpp"
#include "render_core/base/span.hpp"
#include "render_core/design/color.hpp"
#include "render_core/draw/data/glyph_shapes.hpp"
#include "render_core/earth/magnifier.hpp"

namespace tedavis::draw {

/// A glyph instance in the GPU's format.
struct GlyphInstance {
    glm::vec3 place;           ///< relative to the eye, ECEF axes, m
    glm::vec3 size_m;          ///< length, width, height; above 0
    std::int8_t direction[4];  ///< 127ths, ECEF axes; fourth 127: no direction, upright and facing the viewer
    std::uint8_t rgba[4];
};
static_assert(sizeof(GlyphInstance) == 32 && std::is_trivially_copyable_v<GlyphInstance>);

/// `direction`: unit length, or zero for none.
[[nodiscard]] GlyphInstance make_glyph(const glm::vec3& place, const glm::vec3& size_m, const glm::dvec3& direction,
                                       design::Color color) noexcept;

/// The direction of a glyph's +z, as far as its own direction permits.
enum class GlyphFacing : std::uint8_t {
    up,
    eye,
    eye_upright,  ///< and its direction is exactly up
};

struct GlyphRun {
    GlyphShape shape = GlyphShape::arrow;
    GlyphFacing facing = GlyphFacing::up;
    bool is_transparent = false;  ///< drawn after all opaque runs, without writing depth
    std::uint8_t slot = 0;        ///< of GlyphBatch::set_slot()
    std::uint32_t first = 0, count = 0;
};
/// True for solid, opaque glyphs that are not signs of uncertainty.
[[nodiscard]] constexpr bool casts_shadow(const GlyphRun& run) {
    return !run.is_transparent && !is_flat(run.shape) && run.shape != GlyphShape::tetrahedron;
}
inline constexpr std::size_t kMaxGlyphRuns = 96;

class GlyphBatch {
public:
    GlyphBatch() = default;
    explicit GlyphBatch(base::Span<GlyphInstance> instances) : instances_(instances) { use_.capacity = instances.size(); }

    /// Empties the batch; counters of refusals stay.
    void clear();
    /// Sets the slot of the runs added next; 0 after clear().
    void set_slot(std::uint8_t slot) { slot_ = slot; }
    /// Returns instances to be filled at once; empty where they do not fit or `count` is 0.
    [[nodiscard]] base::Span<GlyphInstance> add(GlyphShape shape, GlyphFacing facing, bool is_transparent, std::uint32_t count);

    /// Moves all instances; `by` in metres, ECEF axes.
    void move(const glm::vec3& by) {
        for (std::size_t n = 0; n < use_.in_use; ++n) instances_[n].place += by;
    }
    /// Applies the magnifiers to the instances from the n-th on; positions are relative to the eye point. Sizes are unchanged.
    void move_to_shown(std::size_t n, const earth::Magnifiers& magnifiers, const glm::dvec3& eye);
    [[nodiscard]] base::Span<const GlyphInstance> instances() const { return {instances_.data(), use_.in_use}; }
    [[nodiscard]] base::Span<const GlyphRun> runs() const { return {runs_.data(), runs_.size()}; }
    [[nodiscard]] base::Span<const GlyphInstance> of(const GlyphRun& run) const {
        return instances().subspan(run.first, run.count);
    }
    /// Capacity and use are counted in instances.
    [[nodiscard]] const base::ResourceUse& use() const { return use_; }

private:
    base::Span<GlyphInstance> instances_;
    base::FixedVector<GlyphRun, kMaxGlyphRuns> runs_;
    std::uint8_t slot_ = 0;
    base::ResourceUse use_;
};

}  // namespace tedavis::draw
