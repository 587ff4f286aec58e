#include "render_core/gl/draw_triangles.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/gl_session.hpp"

namespace tedavis::gl::test_draw_triangles {
namespace {

TEST(DrawTriangles, TakesTheCallOfTheDeviceWithTheSamePicture) {
    std::vector<std::uint8_t> reference;
    for (const char* device : {"es2-small", "es3-mid"}) {  // DrawElements, DrawRangeElements
        test_support::GlSession at("egl", device);
        test_support::TriangleScene scene(at.gl, at.device.budget);
        scene.draw(at.gl, *at.surface);
        EXPECT_EQ(at.gl.frame().draws, 1u);
        EXPECT_EQ(at.gl.denied().total, 0u);
        if (reference.empty()) reference = at.pixels();
        EXPECT_EQ(at.pixels(), reference);
    }
}

TEST(DrawTriangles, FirstIndexChoosesThePart) {
    test_support::GlSession at("egl", "es3-mid");
    test_support::TriangleScene scene(at.gl, at.device.budget);
    scene.draw(at.gl, *at.surface);
    at.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_triangles(at.gl, {3, 3, 5});  // the grey one alone, which covers everything
    const auto pixels = at.pixels();
    for (std::size_t i = 0; i < pixels.size(); i += 4) ASSERT_EQ(pixels[i], 90);
}

TEST(DrawTriangles, NothingIsDrawnForNoIndices) {
    test_support::GlSession at("egl", "es3-mid");
    draw_triangles(at.gl, {0, 0, 0});
    EXPECT_EQ(at.gl.frame().draws, 0u);
    EXPECT_EQ(at.gl.denied().total, 0u);
}

}  // namespace
}  // namespace tedavis::gl::test_draw_triangles
