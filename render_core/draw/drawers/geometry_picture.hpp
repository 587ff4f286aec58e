/// The hit of each pixel's ray, for deferred shading (Deering et al. 1988; Saito, Takahashi 1990), as a texture of four words:
///   0  the position in the chunk, 0..1 towards east and towards south, 16 bits each
///   1  the height above MSL, m, as a float
///   2  the normal, ECEF, in octahedral form (Meyer et al. 2010), 2 x 10 bits; sea, 1 bit; void, 1 bit; chunk number, 10 bits
///   3  the depth along the view's axis, m, as a float
/// Where there is no ground the chunk number is 0. ES 3 only; rows from the bottom.
///
/// Memory    16 bytes per pixel from the budget line traced_pictures, and a triangle from symbology_vertices. Thread  the GL
///           thread. Failure  start(): one message.
#pragma once

#include <array>

#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/drawers/screen_triangle.hpp"
#include "render_core/draw/drawn_design.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/terrain/lod_selection.hpp"

namespace tedavis::draw {

/// The words of one pixel.
using GeometryWords = std::array<std::uint32_t, 4>;

/// The chunk number, 1..kMaxGeometrySlots.
[[nodiscard]] constexpr std::uint32_t geometry_number(const terrain::SelectedChunk& chunk) { return chunk.slot + 1; }

class GeometryPicture {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px);
    /// Uploads a whole picture, rows from the bottom.
    void upload(gl::Gl& gl, base::Span<const GeometryWords> words) const;
    [[nodiscard]] const gl::Texture& words() const { return words_; }
    /// Writes the chunk numbers as depths into the bound framebuffer, which must have the picture's size and a cleared depth; its
    /// colours are unchanged. These depths equal those that shaders/terrain_deferred.vert draws a chunk at, bit for bit.
    void leave_numbers(gl::Gl& gl) const;
    /// Writes the ground's depths in the projection of the range, with the caller's depth test and colour mask: 0 for ground that
    /// is nearer than the range, 1 for ground beyond it and for pixels without ground.
    void leave_depths(gl::Gl& gl, const DepthRange& range) const;
    void destroy(gl::Gl& gl);

private:
    void leave(gl::Gl& gl, const gl::Program& program) const;

    gl::Texture words_;
    ScreenTriangle screen_;
    gl::Program numbers_, depths_;
};

}  // namespace tedavis::draw
