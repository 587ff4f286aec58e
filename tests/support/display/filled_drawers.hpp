/// Drawers with the batches that they draw, for tests that fill them by hand.
#pragma once

#include "render_core/draw/drawers/data/solid_drawer.hpp"
#include "render_core/draw/drawers/quad_drawer.hpp"

namespace tedavis::test_support {

class FilledSolids final : public draw::SolidBuffers {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line, base::Arena& memory, const draw::SolidRoom& room,
                                    gl::BufferUse use) {
        filled_ = draw::SolidBatch(memory, room);
        return SolidBuffers::start(gl, line, filled_, room, use);
    }
    [[nodiscard]] draw::SolidBatch& batch() { return filled_; }
    [[nodiscard]] const draw::SolidBatch& batch() const { return filled_; }

private:
    draw::SolidBatch filled_;
};

class FilledQuads final : public draw::QuadDrawer {
public:
    /// True where the arena held the vertices; then one of the drawer's start() is called with batch().
    [[nodiscard]] bool take(base::Arena& memory, std::size_t vertices) { return filled_.start(memory, vertices); }
    [[nodiscard]] draw::QuadBatch& batch() { return filled_; }

private:
    draw::QuadBatch filled_;
};

}  // namespace tedavis::test_support
