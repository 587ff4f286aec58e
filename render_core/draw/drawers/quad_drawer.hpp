/// Draws a batch of quads: symbology or signs over the picture, or links, which are lines that terrain may hide.
///
/// Memory    one vertex and one index buffer from a budget line; the font atlas from the line `font_atlas`, unless another drawer
///           lends its own; all at start(). The batch is the caller's. Thread  the GL thread. Failure  start() gives one message.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/quad_batch.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"

namespace tedavis::draw {

class QuadDrawer {
public:
    /// Starts for symbology. The batch must outlive the drawer and keep its capacity.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch);
    /// Starts for signs, with the font atlas and programs of `lender`, which must outlive this drawer.
    [[nodiscard]] base::Error start_signs(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch,
                                          const QuadDrawer& lender);
    /// Starts for links, without a font atlas.
    [[nodiscard]] base::Error start_links(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch);

    /// Uploads the batch and blends it over the bound framebuffer of `width` x `height` pixels, whose alpha is unchanged.
    /// Leaves depth test, culling and blending off. Returns the number of draws.
    std::uint32_t draw(gl::Gl& gl, std::uint32_t width, std::uint32_t height);
    /// Uploads the batch after a change. Returns false on failure and for an empty batch; draw_within() then draws nothing.
    bool upload(gl::Gl& gl);
    /// For a drawer started by start_links(), after upload(): draws, depth-tested, the parts of the links that lie within the
    /// n-th range of depths. All ranges together draw each part once. Writes no depths. The depth test is on before and after,
    /// culling and blending off.
    std::uint32_t draw_within(gl::Gl& gl, std::uint32_t width, std::uint32_t height, const DepthPlan& plan, std::size_t n);
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] base::Error make_buffers(gl::Gl& gl, base::BudgetLine& line, const QuadBatch& batch);
    [[nodiscard]] base::Error make_typeface(gl::Gl& gl, base::BudgetTable& budget);
    void set_depths(gl::Gl& gl, const DepthPlan& plan, std::size_t n) const;
    std::uint32_t draw_runs(gl::Gl& gl, std::uint32_t width, std::uint32_t height, GLuint last_attribute);

    const QuadBatch* batch_ = nullptr;
    gl::Program box_program_, glyph_program_;
    const gl::Program *boxes_ = nullptr, *glyphs_ = nullptr;  ///< own or lent; the second draws glyphs too; null for links
    gl::Buffer vertices_, indices_;
    gl::Texture atlas_;
    const gl::Texture* typeface_ = nullptr;
    bool is_uploaded_ = false;
};

}  // namespace tedavis::draw
