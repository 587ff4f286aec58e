#include "host_sim/window/painted_rects.hpp"

#include <utility>

namespace tedavis::host_sim {
namespace {

std::array<std::uint8_t, 3> color_at(const std::uint8_t* row, std::uint32_t x) {
    return {row[std::size_t{x} * 4], row[std::size_t{x} * 4 + 1], row[std::size_t{x} * 4 + 2]};
}

/// Those of one row, one pixel high.
std::vector<PaintedRect> changed_runs(const RgbaView& before, const RgbaView& after, std::uint32_t y) {
    const std::uint8_t *const old = before.row(y), *const next = after.row(y);
    std::vector<PaintedRect> runs;
    for (std::uint32_t x = 0; x < after.width; ++x) {
        const std::array<std::uint8_t, 3> color = color_at(next, x);
        if (color == color_at(old, x)) continue;
        if (!runs.empty() && runs.back().left + runs.back().width == x && runs.back().color == color)
            ++runs.back().width;
        else
            runs.push_back({x, y, 1, 1, color});
    }
    return runs;
}

bool goes_on(const PaintedRect& above, const PaintedRect& run) {
    return above.left == run.left && above.width == run.width && above.color == run.color;
}

}  // namespace

std::vector<PaintedRect> changed_rects(const RgbaView& before, const RgbaView& after) {
    std::vector<PaintedRect> rects;
    std::vector<std::size_t> above;  // rectangles that reach the row above, from the left
    for (std::uint32_t y = 0; y < after.height; ++y) {
        std::vector<std::size_t> here;
        auto next = above.begin();
        for (const PaintedRect& run : changed_runs(before, after, y)) {
            while (next != above.end() && rects[*next].left < run.left) ++next;
            if (next != above.end() && goes_on(rects[*next], run)) {
                ++rects[*next].height;
                here.push_back(*next);
            } else {
                here.push_back(rects.size());
                rects.push_back(run);
            }
        }
        above = std::move(here);
    }
    return rects;
}

void paint_rects(gl::Gl& gl, std::uint32_t height_px, const std::vector<PaintedRect>& rects) {
    gl->Enable(GL_SCISSOR_TEST);
    for (const PaintedRect& rect : rects) {
        gl->Scissor(static_cast<GLint>(rect.left), static_cast<GLint>(height_px - rect.top - rect.height),
                    static_cast<GLsizei>(rect.width), static_cast<GLsizei>(rect.height));
        gl->ClearColor(static_cast<float>(rect.color[0]) / 255, static_cast<float>(rect.color[1]) / 255,
                       static_cast<float>(rect.color[2]) / 255, 1);
        gl->Clear(GL_COLOR_BUFFER_BIT);
    }
    gl->Disable(GL_SCISSOR_TEST);
}

}  // namespace tedavis::host_sim
