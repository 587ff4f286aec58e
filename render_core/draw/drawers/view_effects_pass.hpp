/// Effects on the finished picture of the scene, before symbology: depth of field, smoothed edges and shafts of light, in one
/// pass over every pixel.
///
/// The scene is drawn into this pass's picture instead of the surface; its alpha codes distances where a frame blurs. The blur
/// itself is computed in squares of pixels before (scene_blur.hpp).
///
/// Memory    a colour and depth target, and the blur's pictures, from the budget line render_targets. Thread  the GL thread.
/// Failure  one sentence.
#pragma once

#include "render_core/base/ports/surface.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/draw/drawers/scene_blur.hpp"
#include "render_core/draw/drawers/screen_grid.hpp"
#include "render_core/draw/focus_range.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

struct ViewEffectsInput {
    bool blurs = false, smooths = false;
    FocusRange focus;
    const gl::Texture* shafts = nullptr;  ///< of light_shafts.hpp; null: there are none
};

/// Code of a distance as shaders write it into alpha, 0..254/255.
[[nodiscard]] double distance_code(double distance_m) noexcept;

/// The range to which distance codes in alpha are limited: none (1, 1), the whole range (0, 1), or one code.
struct DistanceLeft {
    double least = 1, most = 1;

    [[nodiscard]] bool is_left() const { return least < 1; }
};

/// Effects that frames may request.
struct PictureEffects {
    bool smooths = false, blurs = false, has_shafts = false;
    std::uint32_t blur_square_px = 2;  ///< edge of the squares in which the blur is computed
};

class ViewEffectsPass {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    const PictureEffects& effects, bool with_air = false);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    [[nodiscard]] const gl::RenderTarget& target() const { return target_; }
    /// Draws the target's picture with the effects to `place`. At least one effect must be requested, and must have been
    /// announced at start().
    void finish(gl::Gl& gl, const gl::DrawPlace& place, const ViewEffectsInput& input);
    void destroy(gl::Gl& gl);

    static constexpr std::uint32_t kBlurUnit = 2;  ///< texture units of the blur: this one and the next

private:
    void set_uniforms(gl::Gl& gl, const gl::Program& program, const ViewEffectsInput& input);
    [[nodiscard]] base::Error build_program(gl::Gl& gl, bool blurs, bool smooths, bool shafts);

    gl::RenderTarget target_;
    SceneBlur blur_;
    ScreenGrid grid_;
    gl::Program programs_[2][2][2];  ///< indices: blurs, smooths, subtracts shafts
    bool with_air_ = false;
};

}  // namespace tedavis::draw
