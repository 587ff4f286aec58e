/// Finds the edges of the picture on a surface by Canny's method, returns their density by regions, and shows them.
///
/// The surface is read back in strips, from the top down, and searched by the processor (perception/edge_detector.hpp, default
/// settings). So the edges are those that `perception` finds in the same picture, to the bit, and so are the densities, as
/// floats, on every device. Reading waits for the GPU.
///
/// Memory    the line picture_edges, at start(): a byte a pixel, rows, and a strip of the picture (bytes()). Where edges are
///           shown, a strip of a byte a pixel from render_targets, and a triangle from symbology_vertices.
/// Thread    the GL thread. Failure  start(): one sentence.
#pragma once

#include <array>

#include "render_core/base/ports/surface.hpp"
#include "render_core/draw/drawers/screen_triangle.hpp"
#include "render_core/effects/clutter_budget.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/perception/edge_detector.hpp"

namespace tedavis::draw {

/// `edges`: white edges on black instead of the picture; `regions`: regions tinted by density over the picture.
enum class EdgeView : std::uint8_t { edges, regions };

class PictureEdges {
public:
    /// What start() takes from its arena for a surface of this size.
    [[nodiscard]] static std::uint64_t bytes(std::uint32_t width_px, std::uint32_t height_px);
    /// The surface has this size, at most perception::kMaxPictureSide per side. `memory` is the arena of the line picture_edges.
    /// `shows`: show() may be called.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, base::Arena& memory, std::uint32_t width_px,
                                    std::uint32_t height_px, bool shows);
    [[nodiscard]] bool is_started() const { return !pixels_.empty(); }
    [[nodiscard]] bool can_show() const { return strip_.valid(); }

    /// Measures the surface's current content, which stays unchanged and bound. Returns the share of edges in each region, as
    /// perception::region_densities does; unknown where the surface cannot be read.
    [[nodiscard]] effects::ClutterMap measure(gl::Gl& gl, const base::Surface& surface);
    /// Shows the last measured picture's edges over the bound surface; nothing where it could not be read.
    void show(gl::Gl& gl, EdgeView view) const;
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] base::Error start_views(gl::Gl& gl, base::BudgetTable& budget);
    [[nodiscard]] base::Error build(gl::Gl& gl, EdgeView view);
    [[nodiscard]] bool read(gl::Gl& gl);
    [[nodiscard]] const gl::Program& use(gl::Gl& gl, EdgeView view) const;
    void show_edges(gl::Gl& gl) const;
    void show_regions(gl::Gl& gl) const;

    perception::EdgeDetector detector_;
    base::Span<std::uint8_t> pixels_;       ///< of a strip
    base::Span<const std::uint8_t> edges_;  ///< of the last measured picture
    effects::ClutterMap densities_;         ///< likewise
    ScreenTriangle triangle_;
    gl::Texture strip_;  ///< edges of some rows, or the regions' densities
    std::array<gl::Program, 2> programs_;
    std::uint32_t width_px_ = 0, height_px_ = 0;
};

}  // namespace tedavis::draw
