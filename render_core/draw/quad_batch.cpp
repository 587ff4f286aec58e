#include "render_core/draw/quad_batch.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

constexpr std::size_t kMaxQuadVertices = 65'536;
constexpr float kQuadRim_px = 1.0f;  // room around a box in which its edge fades out

bool finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Cuts the segment at the box (Liang and Barsky 1984); false when nothing is left.
bool cut_at(const Rect& box, Point& from, Point& to) {
    const float dx = to.x - from.x, dy = to.y - from.y;
    const float slopes[4] = {-dx, dx, -dy, dy};
    const float rooms[4] = {from.x - box.x, box.right() - from.x, from.y - box.y, box.bottom() - from.y};
    float first = 0, last = 1;
    for (int side = 0; side < 4; ++side) {
        if (slopes[side] == 0) {
            if (rooms[side] < 0) return false;
            continue;
        }
        const float at = rooms[side] / slopes[side];
        if (slopes[side] < 0)
            first = std::max(first, at);
        else
            last = std::min(last, at);
    }
    if (first > last) return false;
    const Point start = from;
    from = {start.x + first * dx, start.y + first * dy};
    to = {start.x + last * dx, start.y + last * dy};
    return true;
}

Rect common(const Rect& a, const Rect& b) {
    const float x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::min(a.right(), b.right()) - x, std::min(a.bottom(), b.bottom()) - y};
}

constexpr std::size_t kLinkShare = 4;  // links have one in so many of the vertices of billboards

/// Signs and links together.
std::size_t billboard_vertices(const base::BudgetTable& budget) {
    constexpr std::uint64_t kMax = 65'536;
    const std::uint64_t room = budget.find(effects::kSceneBillboardVertices)->bytes / QuadBatch::kBytesAVertex;
    return static_cast<std::size_t>(std::min(room, kMax));
}

}  // namespace

QuadBatch::QuadBatch(base::Span<QuadVertex> vertices, base::Span<std::uint16_t> indices)
    : vertices_(vertices), indices_(indices) {
    use_.capacity = std::min(vertices.size(), kMaxQuadVertices);
}

bool QuadBatch::start(base::Arena& memory, std::size_t max_vertices) {
    const auto vertices = memory.allocate_array<QuadVertex>(max_vertices);
    const auto indices = memory.allocate_array<std::uint16_t>(max_vertices * 3 / 2);
    *this = QuadBatch(vertices, indices);
    return !vertices.empty() && !indices.empty();
}

void QuadBatch::clear() {
    vertex_count_ = 0;
    index_count_ = 0;
    runs_.clear();
    use_.in_use = 0;
    clipped_ = false;
    set_distance(0);
}

void QuadBatch::set_clip(const Rect& clip, ClippedText texts) {
    clip_ = clip;
    clipped_ = true;
    clipped_text_ = texts;
}

/// For a shape, whose run begins here unless the last one goes on.
bool QuadBatch::has_room(std::size_t vertices, std::size_t indices, Shape shape) {
    const bool glyphs = shape == Shape::glyph;
    const bool goes_on = !runs_.empty() && (shape == Shape::box || runs_.back().glyphs == glyphs);
    const bool fits = vertex_count_ + vertices <= use_.capacity && index_count_ + indices <= indices_.size();
    if (fits && (goes_on || runs_.try_push_back({static_cast<std::uint32_t>(index_count_), glyphs}))) return true;
    ++use_.refused;
    return false;
}

QuadVertex& QuadBatch::add_vertex(Point at, Point uv, float extent_x, float extent_y, design::Color color) {
    QuadVertex& vertex = vertices_[vertex_count_++];
    vertex = {at.x, at.y, uv.x, uv.y, extent_x, extent_y, {color.red, color.green, color.blue, color.alpha}, from_m_};
    use_.take(1);
    return vertex;
}

bool QuadBatch::add_quad(const Corner (&corners)[4], float extent_x, float extent_y, design::Color color, Shape shape) {
    if (!has_room(4, 6, shape)) return false;
    const auto first = static_cast<std::uint16_t>(vertex_count_);
    for (const Corner& corner : corners) add_vertex(corner.at, corner.uv, extent_x, extent_y, color);
    for (unsigned offset : {0u, 1u, 2u, 0u, 2u, 3u}) indices_[index_count_++] = static_cast<std::uint16_t>(first + offset);
    return true;
}

bool QuadBatch::line(Point from, Point to, float width_px, design::Color color) {
    if (!finite(from) || !finite(to) || !(width_px > 0)) return true;
    if (clipped_ && !cut_at(clip_.shrunk(width_px / 2), from, to)) return true;
    const float dx = to.x - from.x, dy = to.y - from.y;
    const float length = std::hypot(dx, dy);
    const Point along = length > 0 ? Point{dx / length, dy / length} : Point{1, 0};
    const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
    const float half_length = length / 2, half_width = width_px / 2;
    const float reach_u = half_length + kQuadRim_px, reach_v = half_width + kQuadRim_px;
    Corner corners[4];
    for (int i = 0; i < 4; ++i) {
        const float u = i == 1 || i == 2 ? reach_u : -reach_u;
        const float v = i >= 2 ? reach_v : -reach_v;
        corners[i] = {{middle.x + along.x * u - along.y * v, middle.y + along.y * u + along.x * v}, {u, v}};
    }
    if (!add_quad(corners, half_length, half_width, color)) return false;
    for (std::size_t corner : {1, 2}) vertices_[vertex_count_ - 4 + corner].distance_m = to_m_;
    return true;
}

bool QuadBatch::polyline(base::Span<const Point> points, float width_px, design::Color color, bool closed) {
    const std::size_t count = points.size();
    if (count < 2) return true;
    bool fits = true;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const Point from = points[i], to = points[(i + 1) % count];
        const float length = std::hypot(to.x - from.x, to.y - from.y);
        if (!(length > 0)) continue;
        // Lengthened by half the width so that corners close.
        const float share = width_px / 2 / length;
        const Point past{(to.x - from.x) * share, (to.y - from.y) * share};
        fits = line({from.x - past.x, from.y - past.y}, {to.x + past.x, to.y + past.y}, width_px, color) && fits;
    }
    return fits;
}

bool QuadBatch::box(const Rect& rect, design::Color color) {
    const Rect seen = clipped_ ? common(rect, clip_) : rect;
    if (seen.empty() || !finite({seen.x, seen.y}) || !finite({seen.width, seen.height})) return true;
    const Point middle = seen.center();
    const float half_width = seen.width / 2, half_height = seen.height / 2;
    const float reach_u = half_width + kQuadRim_px, reach_v = half_height + kQuadRim_px;
    Corner corners[4];
    for (int i = 0; i < 4; ++i) {
        const float u = i == 1 || i == 2 ? reach_u : -reach_u;
        const float v = i >= 2 ? reach_v : -reach_v;
        corners[i] = {{middle.x + u, middle.y + v}, {u, v}};
    }
    return add_quad(corners, half_width, half_height, color,
                    seen.width * seen.height >= kLargeBox_px2 ? Shape::large_box : Shape::box);
}

bool QuadBatch::frame(const Rect& rect, float width_px, design::Color color) {
    const Rect middle = rect.shrunk(width_px / 2);
    const Point corners[4] = {
        {middle.x, middle.y}, {middle.right(), middle.y}, {middle.right(), middle.bottom()}, {middle.x, middle.bottom()}};
    return polyline(corners, width_px, color, true);
}

bool QuadBatch::triangle(Point a, Point b, Point c, design::Color color) {
    if (!finite(a) || !finite(b) || !finite(c)) return true;
    if (clipped_ && !(clip_.contains(a) && clip_.contains(b) && clip_.contains(c))) return true;
    if (!has_room(3, 3, Shape::box)) return false;
    for (Point corner : {a, b, c}) {
        indices_[index_count_++] = static_cast<std::uint16_t>(vertex_count_);
        add_vertex(corner, {0, 0}, 1, 1, color);
    }
    return true;
}

bool QuadBatch::text(std::string_view text, Point anchor_point, TextAnchor anchor, const TextStyle& style, float angle_rad) {
    if (!finite(anchor_point) || !std::isfinite(angle_rad) || !(style.size_px > 0)) return true;
    const float width = text_width_px(text, style.size_px);
    const float back = anchor == TextAnchor::left ? 0 : anchor == TextAnchor::center ? width / 2 : width;
    const float down = font_atlas().cap_height_em * style.size_px / 2;
    const Point along{std::cos(angle_rad), std::sin(angle_rad)};
    const Point pen{anchor_point.x - along.x * back - along.y * down, anchor_point.y - along.y * back + along.x * down};
    const bool may_be_cut = clipped_text_ == ClippedText::cut && along.y == 0;
    if (clipped_ && !may_be_cut && is_cut(text, pen, style, along)) return true;
    bool fits = true;
    if (style.halo_px > 0) fits = glyphs(text, pen, style, style.halo_px, style.halo_color, along);
    return glyphs(text, pen, style, 0, style.color, along) && fits;
}

bool QuadBatch::is_cut(std::string_view text, Point pen, const TextStyle& style, Point along) const {
    const FontAtlas& atlas = font_atlas();
    const float texel_px = style.size_px / atlas.texels_per_em;
    // A glyph's box is wider than its ink by the spread, which upright boxes may lose.
    const float margin = along.y == 0 ? atlas.spread_em * style.size_px : 0;
    while (!text.empty()) {
        const Glyph& glyph = glyph_of(take_code_point(text));
        const Rect whole{glyph.left * texel_px, glyph.top * texel_px, glyph.width * texel_px, glyph.height * texel_px};
        const Rect box = whole.shrunk(margin);
        if (!box.empty())
            for (const float x : {box.x, box.right()})
                for (const float y : {box.y, box.bottom()})
                    if (!clip_.contains(Point{pen.x + along.x * x - along.y * y, pen.y + along.y * x + along.x * y})) return true;
        pen = {pen.x + along.x * glyph.advance_em * style.size_px, pen.y + along.y * glyph.advance_em * style.size_px};
    }
    return false;
}

bool QuadBatch::glyphs(std::string_view text, Point pen, const TextStyle& style, float fatten_px, design::Color color,
                       Point along) {
    const FontAtlas& atlas = font_atlas();
    const float texel_px = style.size_px / atlas.texels_per_em;
    const float range_px = 2 * atlas.spread_em * style.size_px;  // pixels between the atlas's values 0 and 1
    const auto atlas_width = static_cast<float>(atlas.width), atlas_height = static_cast<float>(atlas.height);
    const float idle_px = std::max(0.0f, range_px / 2 - fatten_px - 1);  // of the spread: nothing of the glyph reaches it
    const bool upright = along.y == 0;
    bool fits = true;
    while (!text.empty()) {
        const Glyph& glyph = glyph_of(take_code_point(text));
        const Rect whole{glyph.left * texel_px, glyph.top * texel_px, glyph.width * texel_px, glyph.height * texel_px};
        Rect box = whole.shrunk(idle_px);
        if (clipped_ && upright) box = common(box, {clip_.x - pen.x, clip_.y - pen.y, clip_.width, clip_.height});
        Corner corners[4];
        for (int i = 0; i < 4; ++i) {
            const float x = i == 1 || i == 2 ? box.right() : box.x, y = i >= 2 ? box.bottom() : box.y;
            corners[i] = {
                {pen.x + along.x * x - along.y * y, pen.y + along.y * x + along.x * y},
                {(glyph.u + (x - whole.x) / texel_px) / atlas_width, (glyph.v + (y - whole.y) / texel_px) / atlas_height}};
        }
        if (!box.empty()) fits = add_quad(corners, -(1 + fatten_px), range_px, color, Shape::glyph) && fits;
        pen = {pen.x + along.x * glyph.advance_em * style.size_px, pen.y + along.y * glyph.advance_em * style.size_px};
    }
    return fits;
}

std::size_t max_sign_vertices(const base::BudgetTable& budget) {
    const std::size_t vertices = billboard_vertices(budget);
    return vertices - vertices / kLinkShare;
}

std::size_t max_link_vertices(const base::BudgetTable& budget) { return billboard_vertices(budget) / kLinkShare; }

}  // namespace tedavis::draw
