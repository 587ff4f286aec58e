/// Stereo: composes the pictures of both eyes on the surface, side by side or as an anaglyph.
///
/// The scenes of the eyes are drawn one after the other into a picture that is wider than the screen by a margin on either side.
/// A shift of the part that is shown turns the two parallel views into off-axis views of two eyes that share one screen
/// (Woods, Docherty, Koch, "Image distortions in stereoscopic video systems", SPIE 1915, 1993, on parallel cameras).
///
/// Memory, thread and failure are those of a KeptPicture.
#pragma once

#include "render_core/base/ports/surface.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/draw/drawers/kept_picture.hpp"
#include "render_core/draw/eye_side.hpp"

namespace tedavis::draw {

class StereoPass {
public:
    /// Allocates for a screen of `width_px` x `height_px`; an eye's picture is wider by 2 * `margin_px`.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    std::uint32_t margin_px);
    [[nodiscard]] bool is_started() const { return picture_.is_started(); }
    [[nodiscard]] std::uint32_t margin_px() const { return margin_px_; }
    /// The target for one eye's scene.
    [[nodiscard]] const gl::RenderTarget& target() const { return picture_.target(); }
    /// Copies the last drawn picture to the surface: to the eye's half (side by side), to its colour channels (anaglyph, red
    /// for the left eye), or to the whole surface (no mode).
    void put(gl::Gl& gl, const base::Surface& surface, design::StereoMode mode, EyeSide side, std::int32_t shift_px);
    /// Restricts drawing to one half of the surface, for symbology in the screen's plane; without a side the whole surface is
    /// used again.
    static void begin_half(gl::Gl& gl, const base::Surface& surface, EyeSide side);
    static void end_halves(gl::Gl& gl, const base::Surface& surface);
    void destroy(gl::Gl& gl) { picture_.destroy(gl); }

private:
    KeptPicture picture_;
    std::uint32_t width_px_ = 0, margin_px_ = 0;
};

}  // namespace tedavis::draw
