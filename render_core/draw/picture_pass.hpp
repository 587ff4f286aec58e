/// Makes the picture of terrain that was drawn off-screen: the sky where there is none, colours for its codes, and silhouettes
/// where the depth jumps (Saito, Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990), found in the distance
/// code of its alpha. Codes are coloured once a pixel (Deering et al., "The Triangle Processor and Normal Vector Shader",
/// SIGGRAPH 1988).
///
/// Memory    a colour and depth target from the budget line render_targets. Thread  the GL thread. Failure  one sentence.
#pragma once

#include <string_view>

#include "render_core/base/ports/surface.hpp"
#include "render_core/draw/color_table.hpp"
#include "render_core/draw/sky_drawer.hpp"
#include "render_core/draw/terrain_program.hpp"
#include "render_core/draw/view_effects_pass.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

struct PictureInput {
    SkyInput sky;
    bool outlined = false;  ///< with the silhouettes of the style
    DistanceLeft left;      ///< in the picture's alpha
    ScreenPart ground;      ///< beyond it nothing was drawn
    // For codes only.
    bool has_void = false;  ///< ground without data is in view
    HeightSpan heights;     ///< as the terrain was drawn with
    TerrainBands bands;     ///< all of the design, or none
    double haze_per_m = 0;
};

class PicturePass {
public:
    /// For designs that follow one another; those whose output is TerrainOutput::color have no use for it. The first is drawn
    /// first.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    DrawnDesigns designs);
    /// Whether there are the programs that a design needs.
    [[nodiscard]] bool shows(const DrawnDesign& design) const;
    /// The next picture is of this design.
    void set_design(const DrawnDesign& design);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    /// What is drawn from here on goes off-screen, on a picture of nothing but sky.
    void begin(gl::Gl& gl) const;
    /// What was drawn off-screen, or is put there instead: rows from the bottom.
    [[nodiscard]] const gl::Texture& scene() const { return target_.color(); }
    /// Puts the picture there.
    void finish(gl::Gl& gl, const gl::DrawPlace& place, const design::DesignSettings& design, const PictureInput& input);
    /// Paints the ground of the finished picture once more, where the depth there is not empty: near terrain, over what was
    /// drawn behind it since.
    void repaint(gl::Gl& gl, const design::DesignSettings& design, const PictureInput& input);
    void destroy(gl::Gl& gl);

private:
    /// Of coloured terrain, or of codes.
    struct Programs {
        gl::Program ground[2][2];  ///< the second with what is not known; the second with silhouettes
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
    Programs programs_[2];  ///< the second of codes
    bool coded_ = false;    ///< the design's
    bool with_air_ = false;
};

}  // namespace tedavis::draw
