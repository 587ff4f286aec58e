/// Draws sky and ground over the whole screen; the horizon is computed for every pixel from its view ray.
///
/// The horizon is the geometric one: the tangent from the eye to the mean sphere, below the horizontal by the dip. Without
/// terrain the picture is the plain blue over brown of an attitude indicator, without dip.
///
/// Memory    a grid from the line `symbology_vertices`. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/draw/drawers/air_table.hpp"
#include "render_core/draw/drawers/screen_grid.hpp"
#include "render_core/draw/view_frame.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

struct SkyInput {
    ViewFrame view;
    double dip_rad = 0;  ///< horizon_dip_rad(height), 0 for the plain horizon
    design::SkySettings colors;
    bool ground_is_unknown = false;  ///< everything below the horizon is hatched
    AirFrame air;
    glm::dmat3 axes{1.0};  ///< columns forward, right, down in ECEF, for the air
};

/// Uniforms of sky_color.frag and screen.vert, the first ones of every program that shows the sky.
enum SkyUniform : std::size_t {
    kHalfTangent,
    kDownOfAxes,
    kSineOfDip,
    kPixelsPerDown,
    kZenith,
    kHorizon,
    kGroundHorizon,
    kGround,
    kGroundHatch,
    kAirHorizon,
    kSkyAir,  ///< the first of kAirUniformNames
    kSkyUniforms = kSkyAir + kAirUniforms
};
extern const char* const kSkyUniformNames[kSkyUniforms];
/// The program must be in use.
void set_sky_uniforms(gl::Gl& gl, const gl::Program& program, const SkyInput& input);

class SkyDrawer {
public:
    /// `with_air`: frames may have air.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, bool with_air = false);
    /// Colours every pixel of the bound framebuffer where nothing was drawn since its depth was cleared; leaves depth as it
    /// is, depth test, culling and blending off.
    void draw(gl::Gl& gl, const SkyInput& input) const;
    void destroy(gl::Gl& gl);

private:
    gl::Program program_;
    ScreenGrid grid_;
};

}  // namespace tedavis::draw
