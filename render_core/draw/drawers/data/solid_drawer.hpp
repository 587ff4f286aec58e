/// Draws solids: static ones, uploaded when they change, and moving ones, uploaded every frame.
///
/// Before a range of depths is drawn, only the terrain may have written depths in it. The order is: faintly, the pieces that
/// terrain hides; opaque pieces with their rims; blended pieces, the farthest first, each with its far sides before the near
/// ones; at last pieces on the ground, where no other piece hides them.
///
/// Memory    GPU bytes of the budget line scene_solid_vertices; the list of pieces from the arena. Thread  the GL thread.
/// Failure   start(): one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/data/solid_batch.hpp"
#include "render_core/draw/drawers/data/data_frame.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

/// The part of the batches that is drawn.
struct SolidFrame {
    const DataFrame& frame;
    std::uint32_t shown_groups = ~0u;  ///< one bit per group
    std::int64_t time_ns = 0;          ///< the frame's time, for the age of data
    bool has_date = false;             ///< false: data do not age
};

/// A copy of a batch on the GPU.
class SolidBuffers {
public:
    /// The batch must outlive the buffers; `room` is its capacity.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line, const SolidBatch& batch, const SolidRoom& room,
                                    gl::BufferUse use);
    [[nodiscard]] const SolidBatch& batch() const { return *batch_; }
    /// Uploads the batch after a change. Returns false on failure; the buffers must then not be drawn.
    [[nodiscard]] bool upload(gl::Gl& gl) const;
    void bind(gl::Gl& gl) const;
    void destroy(gl::Gl& gl);

private:
    const SolidBatch* batch_ = nullptr;
    gl::Buffer vertices_, indices_;
};

/// Attributes of every program with shaders/solid.vert.
inline constexpr GLuint kSolidAttributes = 3;
inline constexpr gl::AttributeBinding kSolidBindings[kSolidAttributes] = {{"place", 0}, {"normal_unsure", 1}, {"color", 2}};
void point_solid_attributes(gl::Gl& gl, const SolidPiece& piece);
/// Set the uniforms "anchor" and "fading" of such a program. Positions are relative to `eye` (ECEF); `grown` 0..1 is the growth
/// of the uncertainty since the time of the data.
void set_solid_place(gl::Gl& gl, GLint anchor, const SolidPiece& piece, const glm::dvec3& eye);
void set_solid_fading(gl::Gl& gl, GLint fading, const SolidPiece& piece, float grown);

class SolidDrawer {
public:
    /// `most_pieces` is the total of all buffers that are drawn together.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::Arena& memory, std::uint32_t most_pieces, const DataVariant& variant = {});
    [[nodiscard]] bool is_started() const { return program_.valid(); }
    [[nodiscard]] bool has_grid() const { return has_grid_; }
    [[nodiscard]] bool can_magnify() const { return magnified_program_.valid(); }
    /// Draws at most kMaxSolidBuffers buffers, all uploaded. Returns the number of draw calls. The depth test is on, blending and
    /// culling off, before and after.
    std::uint32_t draw(gl::Gl& gl, base::Span<const SolidBuffers* const> solids, const SolidFrame& frame,
                       const DepthRange& range);
    void destroy(gl::Gl& gl);

private:
    struct Ordered {
        double depth_m;
        std::uint32_t buffer, piece;
    };
    enum class Pass : std::uint8_t { ghosts, opaque, mixed, last, distances };
    [[nodiscard]] static bool takes_part(const SolidPiece& piece, Pass pass);
    void choose(base::Span<const SolidBuffers* const> solids, const SolidFrame& frame, const DepthRange& range);
    void order_by_depth();
    void draw_pass(gl::Gl& gl, base::Span<const SolidBuffers* const> solids, const SolidFrame& frame, Pass pass);
    void set_frame(gl::Gl& gl, const SolidFrame& frame, const DepthRange& range);
    void set_piece(gl::Gl& gl, const gl::Program& program, const SolidPiece& piece, const SolidFrame& frame, Pass pass) const;
    void draw_piece(gl::Gl& gl, const SolidPiece& piece, const SolidFrame& frame, Pass pass);
    void draw_parts(gl::Gl& gl, const SolidPiece& piece, const SolidFrame& frame, Pass pass);
    void draw_sides(gl::Gl& gl, const SolidPiece& piece, Pass pass);
    [[nodiscard]] base::Error build(gl::Gl& gl, const DataVariant& variant, gl::Program& program) const;

    gl::Program program_, magnified_program_;
    base::Span<Ordered> order_;
    std::uint32_t chosen_ = 0, draws_ = 0;
    bool has_grid_ = false;
};

}  // namespace tedavis::draw
