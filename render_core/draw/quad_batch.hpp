/// Collects the flat symbology of a frame as triangles in screen pixels: lines, boxes, filled shapes and text. Later shapes
/// cover earlier ones. The batch calls no GL: quad_drawer draws it, and tests read it.
///
/// Edges are smoothed by coverage, not by multisampling: the vertices of a box carry the distance to its edges, and those of a
/// glyph lead to its signed distance in the font atlas. The fragment's coverage is
///   extent.x >= 0:  clamp(min(extent - |uv|) + 0.5)                         box, uv in pixels from its middle
///   extent.x <  0:  clamp((texel(uv) - 0.5) * extent.y - extent.x - 0.5)    glyph, uv in the font atlas 0..1
/// (a glyph's -extent.x is 1 plus the number of pixels by which its outline is thickened, for halos).
///
/// Thread    one. Memory  the caller's. Failure  a triangle, box, line or glyph that does not fit is left out and counted in
/// `use().refused`; texts and polylines may then be incomplete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/resource_use.hpp"
#include "render_core/base/span.hpp"
#include "render_core/design/color.hpp"
#include "render_core/draw/rect.hpp"

namespace tedavis::draw {

struct QuadVertex {
    float x = 0, y = 0;  ///< pixels, y down
    float u = 0, v = 0;
    float extent_x = 0, extent_y = 0;
    std::uint8_t rgba[4] = {};
    float distance_m = 0;  ///< from the eye, along the view, for shapes that terrain may hide; else 0
};
static_assert(sizeof(QuadVertex) == 32);

/// How a line of text looks.
struct TextStyle {
    float size_px = 16;  ///< pixels per em
    design::Color color;
    float halo_px = 0;  ///< dark rim for legibility over terrain
    design::Color halo_color{0, 0, 0, 255};
};
enum class TextAnchor : std::uint8_t { left, center, right };

/// What becomes of a text that a clip's edge crosses.
enum class ClippedText : std::uint8_t {
    left_out,  ///< because a number without its last digit is another number
    cut,       ///< for digits that roll through a window; a turned text is left out all the same
};

/// Consecutive triangles that one program draws.
struct QuadRun {
    std::uint32_t first_index = 0;
    bool glyphs = false;  ///< true: glyphs, and small shapes between them, for which the program is not changed; false: no glyphs
};
inline constexpr std::size_t kMaxQuadRuns = 256;
inline constexpr float kLargeBox_px2 = 4096;

class QuadBatch {
public:
    /// Bytes per vertex that the batch needs, or a buffer with a copy of it.
    static constexpr std::uint64_t kBytesAVertex = sizeof(QuadVertex) + sizeof(std::uint16_t) * 3 / 2;

    QuadBatch() = default;
    /// Allocates room for `max_vertices` vertices, at most 65,536, from the arena. Returns false if the arena is too small.
    [[nodiscard]] bool start(base::Arena& memory, std::size_t max_vertices);
    /// At most 65,536 vertices are used, since indices have 16 bits.
    QuadBatch(base::Span<QuadVertex> vertices, base::Span<std::uint16_t> indices);

    /// Empties the batch, lifts the clip and sets the distance to 0. The count of refused shapes stays.
    void clear();
    /// Limits shapes to this box, until the next call of set_clip(), lift_clip() or clear(). Lines and boxes are cut at the box
    /// (a cut line loses its smoothed end). Triangles that would reach beyond it are left out, and so are texts unless `texts`
    /// says otherwise.
    void set_clip(const Rect& clip, ClippedText texts = ClippedText::left_out);
    void lift_clip() { clipped_ = false; }
    /// Sets the distance of the next shapes from the eye, along the view: lines lead from `from_m` to `to_m`, and other shapes
    /// are at `from_m`. It is 0 in an empty batch.
    void set_distance(double from_m, double to_m) { from_m_ = static_cast<float>(from_m), to_m_ = static_cast<float>(to_m); }
    void set_distance(double distance_m) { set_distance(distance_m, distance_m); }

    /// This and the following functions return false if the shape did not fit. A shape of which nothing is visible (clipped away,
    /// empty, a coordinate that is not a number) is left out and counts as success.
    bool line(Point from, Point to, float width_px, design::Color color);
    /// Draws joined lines from point to point; `closed` adds the line from the last point to the first.
    bool polyline(base::Span<const Point> points, float width_px, design::Color color, bool closed = false);
    bool box(const Rect& rect, design::Color color);
    /// Draws the border of a box; the outer edge of the border is the edge of the box.
    bool frame(const Rect& rect, float width_px, design::Color color);
    bool triangle(Point a, Point b, Point c, design::Color color);
    /// Draws one line of UTF-8 text. `anchor_point` is its left end, middle or right end, at half the height of the capitals;
    /// `angle_rad` turns the line about this point, clockwise on the screen.
    bool text(std::string_view text, Point anchor_point, TextAnchor anchor, const TextStyle& style, float angle_rad = 0);

    [[nodiscard]] base::Span<const QuadVertex> vertices() const { return {vertices_.data(), vertex_count_}; }
    [[nodiscard]] base::Span<const std::uint16_t> indices() const { return {indices_.data(), index_count_}; }
    /// Returns the runs in drawing order. Each ends where the next one begins, and the last ends with the indices.
    [[nodiscard]] base::Span<const QuadRun> runs() const { return {runs_.data(), runs_.size()}; }
    /// Capacity and use are counted in vertices, refusals in shapes.
    [[nodiscard]] const base::ResourceUse& use() const { return use_; }

private:
    struct Corner {
        Point at, uv;
    };
    enum class Shape : std::uint8_t { glyph, box, large_box };
    bool add_quad(const Corner (&corners)[4], float extent_x, float extent_y, design::Color color, Shape shape = Shape::box);
    [[nodiscard]] bool is_cut(std::string_view text, Point pen, const TextStyle& style, Point along) const;
    bool has_room(std::size_t vertices, std::size_t indices, Shape shape);
    bool glyphs(std::string_view text, Point pen, const TextStyle& style, float fatten_px, design::Color color, Point along);
    QuadVertex& add_vertex(Point at, Point uv, float extent_x, float extent_y, design::Color color);

    base::Span<QuadVertex> vertices_;
    base::Span<std::uint16_t> indices_;
    base::FixedVector<QuadRun, kMaxQuadRuns> runs_;
    std::size_t vertex_count_ = 0;
    std::size_t index_count_ = 0;
    Rect clip_;
    bool clipped_ = false;
    ClippedText clipped_text_ = ClippedText::left_out;
    float from_m_ = 0, to_m_ = 0;
    base::ResourceUse use_;
};

/// Return the number of vertices for which a device's budget has room: in the batch of signs, and in the batch of links (lines
/// that terrain may hide).
[[nodiscard]] std::size_t max_sign_vertices(const base::BudgetTable& budget);
[[nodiscard]] std::size_t max_link_vertices(const base::BudgetTable& budget);

}  // namespace tedavis::draw
