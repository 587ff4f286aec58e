/// Volumetric light: shadows of data remove light that air, or haze, scatters towards the viewer.
///
/// At half the picture's size each view ray is walked from the eye to what it meets, as far as casters may shade it, in a bounded
/// number of equal steps. Where a step lies in shadow (shadow_map.hpp) its part of the light is lost: of the same table as aerial
/// perspective (air_table.hpp), so that a ray all in shadow keeps nothing of it and one without is as it was; without air that of
/// haze, a medium of one density and the haze's colour. The picture takes it off (view_effects_pass.hpp), and never more than was
/// added: what the ground and data themselves send keeps its light.
///
/// Steps begin at one of four places by the pixel's place in a square of two, which the picture averages: no grain, no noise from
/// frame to frame. After Tóth, Umenhoffer, "Real-time Volumetric Lighting in Participating Media", Eurographics 2009.
///
/// Memory    a quarter of a picture from the line render_targets. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include "render_core/design/color.hpp"
#include "render_core/draw/drawers/air_table.hpp"
#include "render_core/draw/drawers/screen_grid.hpp"
#include "render_core/draw/drawers/shadow_map.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

struct ShaftInput {
    const terrain::View& view;
    const gl::Texture& scene;  ///< alpha codes distances
    ShadowRead shadow;
    AirFrame air;           ///< without a map haze counts
    double haze_per_m = 0;  ///< as in the picture
    design::Color haze;
    double strength = 1;  ///< 0..1 of the light that is lost
    std::uint32_t steps = 24;
};

class LightShafts {
public:
    static constexpr std::uint32_t kUnit = 1;  ///< for who reads the texture

    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    bool with_air);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    /// Light that is lost, with air its root, else as the haze's colour; alpha: the code of the distance that was walked.
    [[nodiscard]] const gl::Texture& texture() const { return target_.color(); }
    /// Leaves another framebuffer bound.
    void draw(gl::Gl& gl, const ShaftInput& input);
    void destroy(gl::Gl& gl);

private:
    gl::RenderTarget target_;
    ScreenGrid grid_;
    gl::Program program_;
    bool with_air_ = false;
};

}  // namespace tedavis::draw
