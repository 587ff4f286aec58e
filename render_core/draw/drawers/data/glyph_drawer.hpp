/// Draws glyphs: as instances on devices that have them (es3), else as vertices computed on the CPU (es2, sc2).
///
/// Up is the vertical at each glyph (earth::up_at).
///
/// Memory    CPU from the arena, GPU from the budget line scene_glyph_vertices; all at start(). Thread  the GL thread. Failure
/// start() gives one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/data/glyph_batch.hpp"
#include "render_core/draw/data/glyph_memory.hpp"
#include "render_core/draw/drawers/data/data_frame.hpp"
#include "render_core/draw/drawers/data/solid_casters.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

/// Axes of a glyph in ECEF; of unit length.
struct GlyphAxes {
    glm::vec3 x, y, z;
};
/// Computes the axes as the shader does, for devices without instances.
[[nodiscard]] GlyphAxes glyph_axes(const GlyphInstance& glyph, GlyphFacing facing, const glm::vec3& earth_to_eye) noexcept;

class GlyphDrawer {
public:
    /// True where the device draws instances (es3).
    [[nodiscard]] static bool has_instances(const gl::Gl& gl);
    /// Allocates the whole line. Returns an empty error on success.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line, base::Arena& memory, bool with_air = false);
    [[nodiscard]] bool is_started() const { return program_.valid(); }

    /// Uploads the frame's glyphs, once per frame before draw(). The batch must stay unchanged until then. Instances beyond
    /// glyph_instances_within() are left out, last runs first.
    void upload(gl::Gl& gl, const GlyphBatch& batch);
    /// Draws into the bound framebuffer, depth-tested; opaque runs first, then transparent ones, which write no depth. Leaves
    /// depth test on, depth mask on, culling and blending off. Returns the number of draws.
    std::uint32_t draw(gl::Gl& gl, const DataFrame& frame, const DepthRange& range);
    /// Prepares draw_casters(); to be called after start(), only on devices with instances.
    [[nodiscard]] base::Error start_casters(gl::Gl& gl);
    /// Draws opaque solid glyphs, without signs of uncertainty, into the current level of a shadow map. `slots` has one bit per
    /// slot. Returns the number of draws.
    std::uint32_t draw_casters(gl::Gl& gl, std::uint32_t slots, const CasterView& view);
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] base::Error build_programs(gl::Gl& gl);
    [[nodiscard]] base::Error start_corners(const base::BudgetLine& line, base::Arena& memory);
    [[nodiscard]] base::Error make_buffers(gl::Gl& gl, base::BudgetLine& line);
    void begin(gl::Gl& gl, const DataFrame& frame, const DepthRange& range);
    void end(gl::Gl& gl);
    void bind_instances(gl::Gl& gl);
    void draw_instances(gl::Gl& gl, const GlyphRun& run, GLint facing);
    void draw_corners(gl::Gl& gl, const GlyphRun& run, const DataFrame& frame, const DepthRange& range);
    void add_corners(const GlyphInstance& glyph, const GlyphMesh& mesh, const GlyphAxes& axes);
    void flush_corners(gl::Gl& gl);

    gl::Program program_, caster_program_;
    gl::Buffer shape_vertices_, indices_, vertices_;  ///< vertices_: instances, or corners
    base::Span<GlyphShapes> shapes_;
    base::Span<GlyphCorner> corners_;
    base::Span<std::uint16_t> corner_indices_;
    const GlyphBatch* batch_ = nullptr;
    glm::vec3 earth_to_eye_{0};
    std::uint32_t most_instances_ = 0, uploaded_ = 0, corner_count_ = 0, index_count_ = 0, draws_ = 0;
    bool is_instanced_ = false, with_air_ = false;
};

}  // namespace tedavis::draw
