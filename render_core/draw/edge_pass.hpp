/// Finds Canny's edges of the picture on a surface on the GPU, and their density by regions.
///
/// Edges are defined by perception/edge_detector.hpp with its default settings. All sums are integers that a float represents
/// exactly, so that gradients, maxima and thresholds equal those of the CPU pixel by pixel. Only hysteresis is limited: weak
/// edges are followed through kIterations blocks of 4 x 4 pixels from a strong edge. README.md states the resulting difference.
/// Both lanes give the same result.
///
/// The picture is copied and searched in strips, which overlap by what a pixel's edge depends on; kept of the whole picture are
/// three times two bits a pixel, twice. Every target has four bytes a texel, as ES 2 draws into. Nothing is blended or
/// dithered, except in show(). Needs copies of the surface (not `sc2`), and floats of 32 bits in fragment shaders.
///
/// Memory    the line render_targets: 1.5 bytes a pixel of the picture and 10 a pixel of a strip with its neighbours (64 rows on
///           es3, 16 on es2, and 10): 1,928,720 bytes at 1024 x 768 on es3, 620,816 at 640 x 480 on es2. A triangle from
///           symbology_vertices.
/// Thread    the GL thread. Failure  start(): one sentence.
#pragma once

#include <array>

#include "render_core/base/ports/surface.hpp"
#include "render_core/draw/edge_programs.hpp"
#include "render_core/draw/screen_triangle.hpp"
#include "render_core/effects/clutter_budget.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

/// `edges`: white edges on black instead of the picture; `regions`: regions tinted by density over the picture.
enum class EdgeView : std::uint8_t { edges, regions };

class EdgePass {
public:
    /// Number of blocks of 4 x 4 pixels through which weak edges are followed.
    static constexpr int kIterations = 12;

    /// The surface has this size, at most perception::kMaxPictureSide per side. `shows`: show() may be called.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                    bool shows);
    [[nodiscard]] bool is_started() const { return counts_.valid(); }
    [[nodiscard]] bool can_show() const { return programs_.has(EdgeStep::show_edges); }

    /// Measures the surface's current content, which stays unchanged and bound.
    void measure(gl::Gl& gl, const base::Surface& surface);
    /// Returns the share of edges in each region of the last measured picture, as perception::region_densities does; unknown
    /// before the first. Waits for the GPU and reads 192 bytes. The surface must be bound.
    [[nodiscard]] effects::ClutterMap densities(gl::Gl& gl, const base::Surface& surface) const;
    /// Shows the last measured picture's edges over the bound surface; measure() must have been called.
    void show(gl::Gl& gl, EdgeView view) const;
    void destroy(gl::Gl& gl);

private:
    /// Rows of the picture, from the top.
    struct Rows {
        std::uint32_t first, end;
        [[nodiscard]] std::uint32_t count() const { return end - first; }
    };

    [[nodiscard]] base::Error start_edge_targets(gl::Gl& gl, base::BudgetTable& budget);
    [[nodiscard]] Rows around(const Rows& rows, std::uint32_t more) const;
    void copy_planes(gl::Gl& gl, const base::Surface& surface, const Rows& rows);
    void find_crests(gl::Gl& gl, const Rows& read, const Rows& blurred, const Rows& rows);
    void follow(gl::Gl& gl);
    void count(gl::Gl& gl);
    [[nodiscard]] const gl::Program& use(gl::Gl& gl, EdgeStep step, const gl::RenderTarget& of) const;

    EdgePrograms programs_;
    ScreenTriangle triangle_;
    gl::Texture strip_;
    gl::RenderTarget planes_, levels_;
    std::array<gl::RenderTarget, 2> edges_;  ///< weak and strong ones, a texel for 4 x 4 pixels of a colour
    gl::RenderTarget counts_;                ///< of four rows a texel, a column for a part of a region
    gl::RenderTarget regions_;
    std::uint32_t width_px_ = 0, height_px_ = 0, strip_rows_ = 0, parts_ = 1;
    bool is_measured_ = false;
};

}  // namespace tedavis::draw
