/// Draws solids from the sun's direction into a level of a shadow map (draw/drawers/shadow_map.hpp), with the opacity that they
/// have in the picture. Pieces on the ground, rims, cues and margins of uncertain positions cast no shadows, because a shadow
/// implies that an object is there.
///
/// Thin objects are also enlarged by half a texel, so that they cover every texel that they cross: their shadows have no gaps
/// and are at most one texel too wide.
///
/// Thread    the GL thread. Memory  none. Failure  start() gives one sentence.
#pragma once

#include "render_core/draw/data/caster_groups.hpp"
#include "render_core/draw/drawers/data/solid_drawer.hpp"
#include "render_core/draw/shadow_frame.hpp"

namespace tedavis::draw {

struct CasterView {
    const ShadowFrame& shadow;
    std::size_t level = 0;
    double texel_m = 1;
    glm::dvec3 eye{0};  ///< the picture's eye point, ECEF; positions of casters are relative to it
};

class SolidCasters {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl);
    [[nodiscard]] bool is_started() const { return program_.valid(); }
    /// Draws into the current level. All buffers must be uploaded. Returns the number of draw calls.
    std::uint32_t draw(gl::Gl& gl, base::Span<const SolidBuffers* const> solids, const CasterGroups& groups,
                       const CasterView& view) const;
    void destroy(gl::Gl& gl) { program_.destroy(gl); }

private:
    std::uint32_t draw_piece(gl::Gl& gl, const SolidPiece& piece, bool is_thin, const CasterView& view) const;

    gl::Program program_;
};

/// Uniforms of programs with shaders/caster_light.vert; the program is in use.
void set_caster_level(gl::Gl& gl, GLint axes, GLint level, const CasterView& view, double swollen_m);

}  // namespace tedavis::draw
