#include "render_core/draw/drawers/screen_triangle.hpp"

#include <gtest/gtest.h>

#include "render_core/effects/device.hpp"
#include "render_core/gl/program.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_screen_triangle {
namespace {

constexpr std::uint32_t kWidth = 31, kHeight = 17;

gl::Program white(gl::Gl& gl) {
    static constexpr gl::AttributeBinding kAttributes[] = {{"corner", 0}};
    gl::ProgramSource source;
    source.name = "white";
    source.vertex = "VERTEX_IN vec2 corner;\nvoid main() { gl_Position = vec4(corner, 0.0, 1.0); }\n";
    source.fragment = "void main() { FRAGMENT_COLOR = vec4(1.0); }\n";
    source.attributes = kAttributes;
    return gl::build_program(gl, source).value();
}

TEST(ScreenTriangle, CoversEveryPixelOfTheViewportAndNoneBeside) {
    test_support::GlSession session("egl", "es3-mid", kWidth, kHeight);
    const gl::Program program = white(session.gl);
    ScreenTriangle triangle;
    ASSERT_EQ(triangle.start(session.gl, session.device.budget).message.view(), "");
    session.gl.seal();
    session.gl.begin_frame();
    session.gl->ClearColor(0, 0, 0, 1);
    session.gl->Clear(GL_COLOR_BUFFER_BIT);
    program.use(session.gl);
    session.gl->Viewport(5, 3, 20, 10);
    triangle.draw(session.gl);
    const auto rgba = session.pixels();
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const bool is_in = x >= 5 && x < 25 && y >= 3 && y < 13;  // from the bottom
            ASSERT_EQ(rgba[4 * (y * kWidth + x)], is_in ? 255 : 0) << x << ", " << y;
        }
    session.gl.retire();
    triangle.destroy(session.gl);
    EXPECT_EQ(session.device.budget.find(effects::kSymbologyVertices)->use.in_use, 0u);
}

TEST(ScreenTriangle, SaysWhereItsLineHasNoRoom) {
    test_support::GlSession session("egl", "es3-mid", kWidth, kHeight);
    base::BudgetLine& line = *session.device.budget.find(effects::kSymbologyVertices);
    line.bytes = 23;
    ScreenTriangle triangle;
    EXPECT_NE(triangle.start(session.gl, session.device.budget).message.view(), "");
}

}  // namespace
}  // namespace tedavis::draw::test_screen_triangle
