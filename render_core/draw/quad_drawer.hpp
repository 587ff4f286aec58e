/// Holds the batch of the flat symbology and draws it over the picture.
///
/// Memory    the batch from the arena (line `symbology`), one vertex and one index buffer from `symbology_vertices`, the
///           typeface from `font_atlas`; all at start(). Thread  the GL thread. Failure  start() gives one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/quad_batch.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"

namespace tedavis::draw {

class QuadDrawer {
public:
    /// `max_vertices` up to 65,536. An empty sentence means success.
    [[nodiscard]] gl::GlError start(gl::Gl& gl, base::BudgetTable& budget, base::Arena& memory, std::size_t max_vertices);
    /// To be filled for the frame; build_symbology clears it first.
    [[nodiscard]] QuadBatch& batch() { return batch_; }
    [[nodiscard]] const QuadBatch& batch() const { return batch_; }

    /// Uploads the batch and draws it into the bound framebuffer of `width` x `height` pixels, blended over what is there;
    /// the picture's alpha stays. Leaves depth test, culling and blending off. Returns the number of draws.
    std::uint32_t draw(gl::Gl& gl, std::uint32_t width, std::uint32_t height);
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] gl::GlError make_objects(gl::Gl& gl, base::BudgetTable& budget, std::size_t vertices, std::size_t indices);
    QuadBatch batch_;
    gl::Program box_program_, glyph_program_;  ///< the second draws everything
    gl::Buffer vertices_, indices_;
    gl::Texture atlas_;
};

}  // namespace tedavis::draw
