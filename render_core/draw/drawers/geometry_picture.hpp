/// What rays met in each pixel, for deferred shading (Deering et al. 1988; Saito, Takahashi 1990), as a texture of words:
///   0  the part of the chunk's sides east and south, 16 bits each
///   1  the height above MSL, m, as a float
///   2  the normal, ECEF, in octahedral form (Meyer et al. 2010), 10 bits each; sea; void; the number of the chunk, 10 bits
///   3  the depth along the view's axis, m, as a float
/// Where there is no ground the number is 0. ES 3 only; rows from the bottom.
///
/// Memory    16 bytes a pixel of the budget line traced_pictures, 24 of symbology_vertices. Thread  the GL thread. Failure
///           start(): one message.
#pragma once

#include <array>

#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/drawers/screen_triangle.hpp"
#include "render_core/draw/drawn_design.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/terrain/lod_selection.hpp"

namespace tedavis::draw {

/// One pixel.
using GeometryWords = std::array<std::uint32_t, 4>;

/// 1..kMaxGeometrySlots.
[[nodiscard]] constexpr std::uint32_t geometry_number(const terrain::SelectedChunk& chunk) { return chunk.slot + 1; }

class GeometryPicture {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px);
    /// Takes a whole picture.
    void upload(gl::Gl& gl, base::Span<const GeometryWords> words) const;
    [[nodiscard]] const gl::Texture& words() const { return words_; }
    /// Leaves the numbers of chunks in the depth of what is bound, which has the size of the picture and was cleared; its colours
    /// stay. The depth of a chunk's pixels is then that of shaders/terrain_deferred.vert, exactly.
    void leave_numbers(gl::Gl& gl) const;
    /// Draws depths with the caller's depth test and mask of colours, as the range's projection has them: 0 for nearer ground, 1
    /// for farther ground or none.
    void leave_depths(gl::Gl& gl, const DepthRange& range) const;
    void destroy(gl::Gl& gl);

private:
    void leave(gl::Gl& gl, const gl::Program& program) const;

    gl::Texture words_;
    ScreenTriangle screen_;
    gl::Program numbers_, depths_;
};

}  // namespace tedavis::draw
