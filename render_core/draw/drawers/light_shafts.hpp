/// Volumetric light: shadows of data remove light that air, or haze, scatters towards the viewer.
///
/// At half the picture's resolution each view ray is sampled between the eye and its hit, where casters may shade it, in a
/// bounded number of equal steps. Where a step lies in shadow (shadow_map.hpp), the light that the air scatters in over this step
/// is lost. That light comes from the table of aerial perspective (air_table.hpp), so a ray that is wholly in shadow loses all of
/// it, and a ray without shadow nothing; without air it is that of haze of constant density. view_effects_pass.hpp subtracts the
/// lost light, never more than the air had added, so the light of the ground and of data remains.
///
/// The four pixels of each 2 x 2 square begin their steps at four offsets, and the picture averages them: there is no grain and
/// no noise from frame to frame. After Tóth, Umenhoffer, "Real-time Volumetric Lighting in Participating Media", Eurographics
/// 2009.
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
    AirFrame air;           ///< without a map, haze scatters instead
    double haze_per_m = 0;  ///< as in the picture
    design::Color haze;
    double strength = 1;  ///< 0..1 of the light that is lost
    std::uint32_t steps = 24;
};

class LightShafts {
public:
    static constexpr std::uint32_t kUnit = 1;  ///< texture unit of texture() in the programs that read it

    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    bool with_air);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    /// The lost light: with air its square root, else a share of the haze's colour. Alpha is the code of the ray's length.
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
