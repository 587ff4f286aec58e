/// A shadow map of data: casters are drawn from the sun's direction by their owners; programs with shaders/shadow.frag read it.
///
/// It has three levels, stored one above the other: the caster's distance towards the sun in 24 bits of red, green and blue
/// (steps of 5 cm), and in alpha the share of light that it blocks. The terrain is not in the map, so it never shades itself,
/// and the bias only covers rounding (kShadowBias_m), however low the sun. Ground that rises above
/// a caster is lit from half a texel above the caster.
///
/// Penumbrae after Fernando, "Percentage-Closer Soft Shadows", SIGGRAPH 2005, sketches, with the disc of the sun: where the
/// caster is d metres away towards the sun, the shadow is the mean over a disc whose radius is d times the sun's angular radius.
/// Wide discs are read from a coarser level.
///
/// Memory    the budget line render_targets (8 bytes per texel, three levels), at start(). Thread  the GL thread. Failure  one
/// sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/shadow_frame.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

inline constexpr double kShadowBias_m = 0.5;

/// Uniforms of every program that is built with SHADOWS.
inline constexpr std::size_t kShadowUniforms = 4;
inline constexpr const char* kShadowUniformNames[kShadowUniforms] = {"shadow_map", "shadow_axes", "shadow_levels", "shadow_look"};
inline constexpr std::uint32_t kShadowUnit = 10;  ///< texture unit; devices with fewer units have no such programs

/// The shadow map of a frame; without a map there are no shadows.
struct ShadowRead {
    const gl::Texture* map = nullptr;
    const ShadowFrame* frame = nullptr;
    double top_msl_m = 0;  ///< upper bound of the casters' heights above MSL
};

/// The program must be in use; `first` is the index of kShadowUniformNames in its list. The program's positions are relative to
/// `origin` (ECEF, m).
void set_shadow_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const ShadowRead& read,
                         const glm::dvec3& origin);
/// Sets shadow_axes alone.
void set_light_axes(gl::Gl& gl, GLint location, const ShadowFrame& frame, const glm::dvec3& origin);

class ShadowMap {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line, std::uint32_t level_px);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    [[nodiscard]] std::uint32_t level_px() const { return level_px_; }
    [[nodiscard]] const gl::Texture& texture() const { return target_.color(); }
    /// Begins an empty level, into which casters are drawn; depth test on, culling and blending off.
    void begin_level(gl::Gl& gl, std::size_t level) const;
    /// To be called after the last level. The caller must set framebuffer and viewport again.
    void end(gl::Gl& gl) const;
    void destroy(gl::Gl& gl) { target_.destroy(gl); }

private:
    gl::RenderTarget target_;
    std::uint32_t level_px_ = 0;
};

}  // namespace tedavis::draw
