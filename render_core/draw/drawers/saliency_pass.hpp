/// Computes the saliency map of the picture on a surface on the GPU, by the model of perception/saliency_model.hpp, without
/// reading anything back.
///
/// A pixel of the map covers 2^level x 2^level pixels of the picture. The picture is copied in strips, so that no target of its
/// size is needed. Every target has four bytes per texel, which ES 2 can draw into: numbers are packed
/// (shaders/saliency_codes.frag), which costs some precision; draw/README.md compares the map with that of the CPU.
///
/// Memory    the line render_targets: 50 bytes per pixel of the map, and a strip; a triangle from symbology_vertices.
/// Thread    the GL thread. Failure  start(): one sentence.
#pragma once

#include <array>

#include "render_core/base/ports/surface.hpp"
#include "render_core/base/time.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/draw/drawers/saliency_programs.hpp"
#include "render_core/draw/drawers/screen_triangle.hpp"
#include "render_core/gl/render_target.hpp"
#include "render_core/perception/center_surround.hpp"
#include "render_core/perception/oriented_energy.hpp"

namespace tedavis::draw {

/// Level of the map of a picture on a lane: that of the CPU on es3, one coarser on es2.
[[nodiscard]] int saliency_map_level(effects::Lane lane, std::uint32_t width_px, std::uint32_t height_px) noexcept;

class SaliencyPass {
public:
    /// The surface has this size. `shows_map` and `shows_heat` are the views that show() may be called with.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    bool shows_map, bool shows_heat);
    [[nodiscard]] bool is_started() const { return map_.valid(); }
    [[nodiscard]] bool can_show(design::SaliencyView view) const;

    /// Measures the surface's current content, which stays unchanged and bound.
    void measure(gl::Gl& gl, const base::Surface& surface, design::SaliencyScale scale);
    /// Shows the last map over the bound surface.
    void show(gl::Gl& gl, design::SaliencyView view);
    /// 0..1 in the first two bytes (the first is the higher one), rows from the picture's top.
    [[nodiscard]] const gl::RenderTarget& map() const { return map_; }
    void destroy(gl::Gl& gl);

private:
    static constexpr int kLevels = perception::kFeatureLevels, kCenters = perception::kCenters;
    static constexpr std::size_t kGroups = 3;  ///< of feature maps, four per texel: lightness and a*; b*; directions
    static constexpr std::size_t kScratch = 3;

    struct Feature {
        SaliencyStep step;
        const std::array<gl::RenderTarget, kLevels>& levels;
    };

    [[nodiscard]] base::Error start_targets(gl::Gl& gl, base::BudgetTable& budget);
    void copy_colors(gl::Gl& gl, const base::Surface& surface);
    void soften(gl::Gl& gl);
    void measure_directions(gl::Gl& gl);
    void compare(gl::Gl& gl, const Feature& feature, std::size_t group);
    void find_most(gl::Gl& gl, SaliencyStep step, const gl::RenderTarget& of, int column);
    void count(gl::Gl& gl, const gl::RenderTarget& of, int column);
    void gather(gl::Gl& gl, SaliencyStep step, int column, int row);
    void mix(gl::Gl& gl);
    void run(gl::Gl& gl, const gl::Program& program, const gl::RenderTarget& target, int column, int row);
    void set_taps(gl::Gl& gl, const gl::Program& program, SaliencyUniform at, const perception::GaborTaps::Taps& taps) const;
    void read_figures(gl::Gl& gl, const gl::Program& program) const;

    SaliencyPrograms programs_;
    ScreenTriangle triangle_;
    gl::Texture strip_;
    std::array<gl::RenderTarget, kLevels> colors_, straight_, slanted_, directions_;
    std::array<std::array<gl::RenderTarget, kCenters>, kGroups> contrasts_;
    gl::RenderTarget conspicuity_, map_;
    gl::RenderTarget total_;                          ///< the sum of conspicuities; before, the colours that soften() reads
    std::array<gl::RenderTarget, kScratch> scratch_;  ///< reductions of 16 x 16 texels to one, until 16 x 16 at most are left
    gl::RenderTarget figures_;                        ///< laid out as shaders/saliency_weights.frag states
    perception::GaborTaps taps_;
    std::uint32_t width_px_ = 0, height_px_ = 0;
    int level_ = 0;
    bool is_fixed_ = false;
};

}  // namespace tedavis::draw
