/// Blur of what is out of focus in the picture of the scene, in squares of some pixels a side: view_effects_pass.hpp mixes the
/// result into the sharp picture.
///
/// After Potmesil, Chakravarty, "A Lens and Aperture Camera Model for Synthetic Image Generation", SIGGRAPH 1981, gathered at
/// every square. Two passes: each square takes colour and blur of those of its pixels that are least out of focus
/// (blur_source.frag), then the colour of its surroundings and their share (blur_gather.frag). Squares of one pixel give the
/// blur of each pixel itself.
///
/// Memory    two pictures of squares, four bytes a square, from the line render_targets. Thread  the GL thread.
/// Failure   start(): one sentence.
#pragma once

#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/drawers/screen_grid.hpp"
#include "render_core/draw/focus_range.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

class SceneBlur {
public:
    /// `width_px`, `height_px`: of the scene. `square_px`: edge of a square, 1 to 4.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    std::uint32_t square_px);
    [[nodiscard]] std::uint32_t square_px() const { return square_px_; }
    /// `scene`: alpha codes distances. Leaves another framebuffer bound.
    void draw(gl::Gl& gl, const ScreenGrid& grid, const gl::Texture& scene, const FocusRange& focus);
    /// Binds squares and surroundings to the texture units `first_unit` and the next one.
    void bind(gl::Gl& gl, std::uint32_t first_unit) const;
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] base::Error build_programs(gl::Gl& gl);

    gl::RenderTarget squares_, surroundings_;
    gl::Program reducing_, gathering_;
    std::uint32_t square_px_ = 1;
};

/// The line of a fragment shader that states the edge of a square as TEXEL.
[[nodiscard]] base::FixedString<31> square_definition(std::uint32_t square_px);

void set_focus_uniform(gl::Gl& gl, std::int32_t uniform, const FocusRange& focus);

}  // namespace tedavis::draw
