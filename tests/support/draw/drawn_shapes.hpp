/// Lines, triangles and characters read back from a quad batch, with their colors: what tests of symbology measure.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/quad_batch.hpp"

namespace tedavis::test_support {

struct DrawnLine {
    draw::Point from, to;
    float width = 0;
    design::Color color;
};
struct DrawnTriangle {
    draw::Point corners[3];
    design::Color color;
};
struct DrawnGlyph {
    char character = 0;
    draw::Point at;
    design::Color color;
    float em_px = 0;  ///< the size of its text
};
struct DrawnShapes {
    std::vector<DrawnLine> lines;  ///< boxes too: as wide lines
    std::vector<DrawnTriangle> triangles;
    std::vector<DrawnGlyph> glyphs;  ///< halos left out
};

inline bool is_same_color(design::Color a, design::Color b) { return a.red == b.red && a.green == b.green && a.blue == b.blue; }

namespace drawn_shapes {

inline draw::Point point_of(const draw::QuadVertex& v) { return {v.x, v.y}; }

inline DrawnLine line_of(const draw::QuadVertex (&quad)[4], design::Color color) {
    const draw::Point middle{(quad[0].x + quad[2].x) / 2, (quad[0].y + quad[2].y) / 2};
    const float x = quad[1].x - quad[0].x, y = quad[1].y - quad[0].y, length = std::hypot(x, y);
    const float half_x = quad[0].extent_x * x / length, half_y = quad[0].extent_x * y / length;
    return {{middle.x - half_x, middle.y - half_y}, {middle.x + half_x, middle.y + half_y}, 2 * quad[0].extent_y, color};
}

inline char character_of(const draw::QuadVertex (&quad)[4]) {
    const draw::FontAtlas& atlas = draw::font_atlas();
    const float u = (quad[0].u + quad[2].u) / 2 * static_cast<float>(atlas.width);
    const float v = (quad[0].v + quad[2].v) / 2 * static_cast<float>(atlas.height);
    for (const draw::Glyph& glyph : atlas.glyphs)
        if (u > glyph.u && u < glyph.u + glyph.width && v > glyph.v && v < glyph.v + glyph.height)
            return static_cast<char>(glyph.code_point);
    return '?';
}

}  // namespace drawn_shapes

inline DrawnShapes drawn_shapes_of(const draw::QuadBatch& batch) {
    using namespace drawn_shapes;
    DrawnShapes shapes;
    const auto vertices = batch.vertices();
    const auto indices = batch.indices();
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const draw::QuadVertex &a = vertices[indices[i]], &b = vertices[indices[i + 1]], &c = vertices[indices[i + 2]];
        const design::Color color{a.rgba[0], a.rgba[1], a.rgba[2], a.rgba[3]};
        // A quad's second triangle begins with the first corner of its first one.
        const bool is_quad = i + 5 < indices.size() && indices[i + 3] == indices[i];
        if (!is_quad) {
            shapes.triangles.push_back({{point_of(a), point_of(b), point_of(c)}, color});
            continue;
        }
        const draw::QuadVertex quad[4] = {a, b, c, vertices[indices[i + 5]]};
        i += 3;
        if (a.extent_x >= 0) {
            shapes.lines.push_back(line_of(quad, color));
        } else if (a.extent_x == -1.0f) {
            const draw::Point middle{(a.x + c.x) / 2, (a.y + c.y) / 2};
            shapes.glyphs.push_back({character_of(quad), middle, color, a.extent_y / (2 * draw::font_atlas().spread_em)});
        }
    }
    return shapes;
}

/// The characters of one color, in the order in which they were drawn.
inline std::string drawn_text(const DrawnShapes& shapes, design::Color color) {
    std::string text;
    for (const DrawnGlyph& glyph : shapes.glyphs)
        if (is_same_color(glyph.color, color)) text += glyph.character;
    return text;
}

}  // namespace tedavis::test_support
