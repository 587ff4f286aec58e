#include "render_core/draw/drawers/screen_grid.hpp"

#include "render_core/effects/device.hpp"
#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint16_t kColumns = 32, kRows = 24;
constexpr std::uint32_t kVertices = (kColumns + 1) * (kRows + 1), kIndices = kColumns * kRows * 6;

struct GridShape {
    float places[kVertices * 2];
    std::uint16_t corners[kIndices];

    GridShape() : places{}, corners{} {
        std::size_t at = 0;
        for (std::uint16_t row = 0; row <= kRows; ++row)
            for (std::uint16_t column = 0; column <= kColumns; ++column) {
                places[at++] = 2.0f * static_cast<float>(column) / kColumns - 1.0f;
                places[at++] = 2.0f * static_cast<float>(row) / kRows - 1.0f;
            }
        at = 0;
        for (std::uint16_t row = 0; row < kRows; ++row)
            for (std::uint16_t column = 0; column < kColumns; ++column) {
                const unsigned first = row * (kColumns + 1u) + column, above = first + kColumns + 1u;
                for (const unsigned corner : {first, first + 1u, above + 1u, first, above + 1u, above})
                    corners[at++] = static_cast<std::uint16_t>(corner);
            }
    }
};

bool reaches(const ScreenPart& part, std::uint32_t column, std::uint32_t row) {
    const std::uint32_t least_x = part.right > 0 ? column : column + 1, least_y = part.up > 0 ? row : row + 1;
    const float x = 2.0f * static_cast<float>(least_x) / kColumns - 1.0f, y = 2.0f * static_cast<float>(least_y) / kRows - 1.0f;
    return !(x * part.right + y * part.up > part.limit);
}

}  // namespace

base::Error ScreenGrid::start(gl::Gl& gl, base::BudgetTable& budget) {
    const GridShape shape;
    base::BudgetLine& line = *budget.find(effects::kSymbologyVertices);
    auto vertices = gl::make_buffer(gl, line, gl::BufferKind::vertices, gl::BufferUse::fixed, sizeof shape.places);
    if (!vertices.ok()) return vertices.error();
    vertices_ = static_cast<gl::Buffer&&>(vertices.value());
    auto indices = gl::make_buffer(gl, line, gl::BufferKind::indices, gl::BufferUse::fixed, sizeof shape.corners);
    if (!indices.ok()) return indices.error();
    indices_ = static_cast<gl::Buffer&&>(indices.value());
    if (!vertices_.upload(gl, 0, shape.places, sizeof shape.places) ||
        !indices_.upload(gl, 0, shape.corners, sizeof shape.corners))
        return base::make_error("the screen's grid cannot be uploaded");
    return {};
}

void ScreenGrid::draw_cells(gl::Gl& gl, const ScreenPart& part, bool inside) const {
    vertices_.bind(gl);
    indices_.bind(gl);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    constexpr std::uint32_t kCells = kColumns * kRows, kCellIndices = kIndices / kCells;
    std::uint32_t first = 0;  // of the cells that follow each other without a gap
    for (std::uint32_t cell = 0; cell <= kCells; ++cell) {
        if (cell < kCells && reaches(part, cell % kColumns, cell / kColumns) == inside) continue;
        gl::draw_triangles(gl, {first * kCellIndices, (cell - first) * kCellIndices, kVertices - 1});
        first = cell + 1;
    }
    gl->DisableVertexAttribArray(0);
}

void ScreenGrid::destroy(gl::Gl& gl) {
    vertices_.destroy(gl);
    indices_.destroy(gl);
}

}  // namespace tedavis::draw
