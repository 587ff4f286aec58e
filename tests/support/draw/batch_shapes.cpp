#include "tests/support/draw/batch_shapes.hpp"

#include <algorithm>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::test_support {
namespace {

draw::Rect box_around(const draw::Rect& a, const draw::Rect& b) {
    const float x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

char letter_at(float u, float v) {
    for (const draw::Glyph& glyph : draw::font_atlas().glyphs)
        if (u > glyph.u && u < glyph.u + glyph.width && v > glyph.v && v < glyph.v + glyph.height)
            return static_cast<char>(glyph.code_point);
    return '?';
}

BatchShape shape_of(const draw::QuadBatch& batch, std::size_t first, std::size_t corners) {
    const auto vertices = batch.vertices();
    const draw::QuadVertex& head = vertices[first];
    BatchShape shape;
    shape.color = {head.rgba[0], head.rgba[1], head.rgba[2], head.rgba[3]};
    shape.bounds = {head.x, head.y, 0, 0};
    for (std::size_t i = 1; i < corners; ++i)
        shape.bounds = box_around(shape.bounds, {vertices[first + i].x, vertices[first + i].y, 0, 0});
    if (head.extent_x < 0) {
        const draw::FontAtlas& atlas = draw::font_atlas();
        const draw::QuadVertex& opposite = vertices[first + 2];
        shape.letter = letter_at((head.u + opposite.u) / 2 * static_cast<float>(atlas.width),
                                 (head.v + opposite.v) / 2 * static_cast<float>(atlas.height));
        shape.is_rim = head.extent_x < -1;
    } else if (corners == 4) {
        shape.bounds = shape.bounds.shrunk(1);
    }
    return shape;
}

bool has_middle_in(const BatchShape& shape, const draw::Rect& where) { return where.contains(shape.bounds.center()); }

}  // namespace

std::vector<BatchShape> shapes_of(const draw::QuadBatch& batch) {
    std::vector<BatchShape> shapes;
    const auto indices = batch.indices();
    for (std::size_t i = 0; i + 2 < indices.size();) {
        const bool is_quad = i + 5 < indices.size() && indices[i + 3] == indices[i] && indices[i + 4] == indices[i + 2];
        shapes.push_back(shape_of(batch, indices[i], is_quad ? 4 : 3));
        i += is_quad ? 6 : 3;
    }
    return shapes;
}

std::vector<BatchShape> shapes_in(const draw::QuadBatch& batch, const draw::Rect& where, design::Color color) {
    std::vector<BatchShape> found;
    for (const BatchShape& shape : shapes_of(batch))
        if (shape.letter == 0 && shape.has(color) && has_middle_in(shape, where)) found.push_back(shape);
    return found;
}

std::string text_in(const draw::QuadBatch& batch, const draw::Rect& where, design::Color color) {
    std::string text;
    for (const BatchShape& shape : shapes_of(batch))
        if (shape.letter != 0 && !shape.is_rim && shape.has(color) && has_middle_in(shape, where)) text += shape.letter;
    return text;
}

draw::Rect bounds_of(const std::vector<BatchShape>& shapes) {
    if (shapes.empty()) return {};
    draw::Rect bounds = shapes.front().bounds;
    for (const BatchShape& shape : shapes) bounds = box_around(bounds, shape.bounds);
    return bounds;
}

}  // namespace tedavis::test_support
