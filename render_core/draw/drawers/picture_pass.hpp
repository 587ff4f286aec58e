/// Composes the picture from terrain that was drawn off-screen: sky where there is no terrain, colours for its codes, and
/// silhouettes where the depth jumps (Saito, Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990), found in the
/// distance code of its alpha. Codes are coloured once per pixel (Deering et al., "The Triangle Processor and Normal Vector
/// Shader", SIGGRAPH 1988).
///
/// Memory    a colour and depth target from the budget line render_targets. Thread  the GL thread. Failure  one sentence.
#pragma once

#include <string_view>

#include "render_core/base/ports/surface.hpp"
#include "render_core/draw/drawers/color_table.hpp"
#include "render_core/draw/drawers/sky_drawer.hpp"
#include "render_core/draw/drawers/terrain_program.hpp"
#include "render_core/draw/drawers/view_effects_pass.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

struct PictureInput {
    SkyInput sky;
    bool outlined = false;  ///< with the silhouettes of the style
    DistanceLeft left;      ///< in the picture's alpha
    ScreenPart ground;      ///< part of the screen outside which nothing was drawn
    // For codes only.
    bool has_void = false;  ///< ground without data is in view
    HeightSpan heights;     ///< as the terrain was drawn with
    TerrainBands bands;     ///< all of the design, or none
    AlertColors alert;      ///< as the terrain was drawn with
    double haze_per_m = 0;
};

class PicturePass {
public:
    /// Prepares programs for the designs of a display; designs with the output TerrainOutput::color do not use this pass. The
    /// first design is the initial one.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    DrawnDesigns designs);
    /// True where the programs that a design needs exist.
    [[nodiscard]] bool shows(const DrawnDesign& design) const;
    /// Sets the design of the next picture.
    void set_design(const DrawnDesign& design);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    /// Begins the off-screen picture, which is initialised as sky.
    void begin(gl::Gl& gl) const;
    /// The off-screen picture, rows from the bottom.
    [[nodiscard]] const gl::Texture& scene() const { return target_.color(); }
    /// Composes the picture at `place`.
    void finish(gl::Gl& gl, const gl::DrawPlace& place, const design::DesignSettings& design, const PictureInput& input);
    /// Draws the ground of the finished picture again where depth has been written: near terrain, over objects that were drawn
    /// behind it in the meantime.
    void repaint(gl::Gl& gl, const design::DesignSettings& design, const PictureInput& input);
    void destroy(gl::Gl& gl);

private:
    /// Programs for coloured terrain, or for codes.
    struct Programs {
        gl::Program ground[2][2];  ///< first index: with hatched unknown ground; second: with silhouettes
        gl::Program sky;
    };
    [[nodiscard]] base::Error build_programs(gl::Gl& gl, bool coded, bool outlined);
    [[nodiscard]] base::Error build_program(gl::Gl& gl, bool coded, std::string_view defines, gl::Program& program) const;
    void paint_ground(gl::Gl& gl, const design::DesignSettings& design, const PictureInput& input) const;
    void use(gl::Gl& gl, const gl::Program& program, const design::DesignSettings& design, const PictureInput& input) const;
    void set_outline(gl::Gl& gl, const gl::Program& program, const design::SketchSettings& sketch) const;
    void set_colors(gl::Gl& gl, const gl::Program& program, const design::DesignSettings& design) const;

    gl::RenderTarget target_;
    ScreenGrid grid_;
    ColorTable colors_;
    Programs programs_[2];  ///< the second for codes
    bool coded_ = false;    ///< the design's
    bool with_air_ = false;
};

}  // namespace tedavis::draw
