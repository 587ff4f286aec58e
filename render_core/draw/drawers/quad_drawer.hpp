/// Draws a batch of flat symbology over the picture: symbology, signs; or lines that stand among the terrain.
///
/// Memory    one vertex and one index buffer from a budget line, the typeface from `font_atlas` unless another drawer lends its
///           own; all at start(). The batch is the caller's. Thread  the GL thread. Failure  start() gives one message.
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
    /// The batch must stay, and be of no more vertices later.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch);
    /// Of signs, with typeface and programs of `lender`, which must outlive it.
    [[nodiscard]] base::Error start_signs(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch,
                                          const QuadDrawer& lender);
    /// Of lines among the terrain, without a typeface.
    [[nodiscard]] base::Error start_links(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch);

    /// Uploads the batch and draws it into the bound framebuffer of `width` x `height` pixels, blended over what is there;
    /// the picture's alpha stays. Leaves depth test, culling and blending off. Returns the number of draws.
    std::uint32_t draw(gl::Gl& gl, std::uint32_t width, std::uint32_t height);
    /// After the batch has changed. False when it cannot be had; then draw_within() draws nothing.
    bool upload(gl::Gl& gl);
    /// Of a drawer started by start_links(), after upload(): what stands within the n-th range, where nothing nearer is drawn.
    /// All ranges together draw everything once. Writes no depths. The depth test is on before and after, culling and blending
    /// off.
    std::uint32_t draw_within(gl::Gl& gl, std::uint32_t width, std::uint32_t height, const DepthPlan& plan, std::size_t n);
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] base::Error make_buffers(gl::Gl& gl, base::BudgetLine& line, const QuadBatch& batch);
    [[nodiscard]] base::Error make_typeface(gl::Gl& gl, base::BudgetTable& budget);
    void set_depths(gl::Gl& gl, const DepthPlan& plan, std::size_t n) const;
    std::uint32_t draw_runs(gl::Gl& gl, std::uint32_t width, std::uint32_t height, GLuint last_attribute);

    const QuadBatch* batch_ = nullptr;
    gl::Program box_program_, glyph_program_;
    const gl::Program *boxes_ = nullptr, *glyphs_ = nullptr;  ///< own or lent; the second draws everything, links have none
    gl::Buffer vertices_, indices_;
    gl::Texture atlas_;
    const gl::Texture* typeface_ = nullptr;
    bool is_uploaded_ = false;
};

}  // namespace tedavis::draw
