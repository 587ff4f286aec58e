/// Draws solids as the sun sees them, into a level of a map of shadows (draw/shadow_map.hpp), each as dense as it is in the
/// picture. What lies on the ground casts none, nor do rims, cues and margins of what is unsure: a shadow says that something is
/// there.
///
/// Thin things are swollen by half a texel besides, so that they are in every texel that they cross: their shadows are never
/// broken, and at most a texel too wide.
///
/// Thread    the GL thread. Memory  none. Failure  start() gives one sentence.
#pragma once

#include "render_core/draw/data/solid_drawer.hpp"
#include "render_core/draw/shadow_frame.hpp"

namespace tedavis::draw {

/// A bit a group.
struct CasterGroups {
    std::uint32_t all = 0, thin = 0;
};

/// Whether a piece casts a shadow at all.
[[nodiscard]] bool casts_shadow(const SolidPiece& piece, const CasterGroups& groups);

struct CasterView {
    const ShadowFrame& shadow;
    std::size_t level = 0;
    double texel_m = 1;
    glm::dvec3 eye{0};  ///< of the picture, ECEF: places of casters are relative to it
};

class SolidCasters {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl);
    [[nodiscard]] bool is_started() const { return program_.valid(); }
    /// Into the level that has been begun. All are uploaded. Returns the number of draws.
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
