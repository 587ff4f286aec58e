/// Collects the flat symbology of a frame as triangles in screen pixels: lines, boxes, filled shapes and text, in the
/// order in which they cover each other. No GL: quad_drawer draws it, tests read it.
///
/// Edges are smoothed by coverage, not by multisampling: a box carries the distance to its edges, a glyph its signed
/// distance. The fragment's coverage is
///   extent.x >= 0:  clamp(min(extent - |uv|) + 0.5)                         box, uv in pixels from its middle
///   extent.x <  0:  clamp((texel(uv) - 0.5) * extent.y - extent.x - 0.5)    glyph, uv in the font atlas 0..1
/// (a glyph's -extent.x is 1 plus the pixels by which its outline is fattened: halos).
///
/// Thread    one. Memory  the caller's. Failure  what does not fit is left out whole and counted in `use().refused`.
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
    float distance_m = 0;  ///< along the view, of lines that terrain may hide; else 0
};
static_assert(sizeof(QuadVertex) == 32);

/// How a line of text looks.
struct TextStyle {
    float size_px = 16;  ///< pixels an em
    design::Color color;
    float halo_px = 0;  ///< dark rim for legibility over terrain
    design::Color halo_color{0, 0, 0, 255};
};
enum class TextAnchor : std::uint8_t { left, center, right };

/// Triangles that follow each other and are drawn by one program.
struct QuadRun {
    std::uint32_t first_index = 0;
    bool glyphs = false;  ///< and what is small between them, not worth another program; else no glyphs
};
inline constexpr std::size_t kMaxQuadRuns = 256;
inline constexpr float kLargeBox_px2 = 4096;

class QuadBatch {
public:
    /// Bytes of the batch, and of buffers that hold a copy of it, for each vertex.
    static constexpr std::uint64_t kBytesAVertex = sizeof(QuadVertex) + sizeof(std::uint16_t) * 3 / 2;

    QuadBatch() = default;
    /// With room for so many vertices, at most 65,536, from an arena. False where it does not hold them.
    [[nodiscard]] bool start(base::Arena& memory, std::size_t max_vertices);
    /// At most 65,536 vertices are used, since indices have 16 bits.
    QuadBatch(base::Span<QuadVertex> vertices, base::Span<std::uint16_t> indices);

    /// Empties the batch and lifts the clip; counters of refusals stay.
    void clear();
    /// Until the next call, shapes are cut at this box: lines exactly (a cut line loses its smoothed end); triangles and
    /// texts are left out where they would reach beyond it, for a number without its last digit is another number.
    void set_clip(const Rect& clip);
    void lift_clip() { clipped_ = false; }
    /// What follows stands so far ahead of the eye; lines lead from the first distance to the second. Empty batches stand at 0.
    void set_distance(double from_m, double to_m) { from_m_ = static_cast<float>(from_m), to_m_ = static_cast<float>(to_m); }
    void set_distance(double distance_m) { set_distance(distance_m, distance_m); }

    /// False when it did not fit. Nothing visible (clipped away, empty) is a success. Not-a-number draws nothing.
    bool line(Point from, Point to, float width_px, design::Color color);
    /// Joined lines; `closed` adds the one from the last point to the first.
    bool polyline(base::Span<const Point> points, float width_px, design::Color color, bool closed = false);
    bool box(const Rect& rect, design::Color color);
    /// The rim of a box, its outer edge on the box's edge.
    bool frame(const Rect& rect, float width_px, design::Color color);
    bool triangle(Point a, Point b, Point c, design::Color color);
    /// One line of UTF-8 text. `anchor_point` is the left, middle or right end, at half the height of the capitals;
    /// `angle_rad` turns the line about it, clockwise on the screen.
    bool text(std::string_view text, Point anchor_point, TextAnchor anchor, const TextStyle& style, float angle_rad = 0);

    [[nodiscard]] base::Span<const QuadVertex> vertices() const { return {vertices_.data(), vertex_count_}; }
    [[nodiscard]] base::Span<const std::uint16_t> indices() const { return {indices_.data(), index_count_}; }
    /// In drawing order; the last one ends with the indices.
    [[nodiscard]] base::Span<const QuadRun> runs() const { return {runs_.data(), runs_.size()}; }
    /// In vertices.
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
    float from_m_ = 0, to_m_ = 0;
    base::ResourceUse use_;
};

/// Vertices of the batches of signs, and of the lines among the terrain, that a device's budget holds.
[[nodiscard]] std::size_t max_sign_vertices(const base::BudgetTable& budget);
[[nodiscard]] std::size_t max_link_vertices(const base::BudgetTable& budget);

}  // namespace tedavis::draw
