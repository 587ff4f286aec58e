#include "render_core/draw/quad_drawer.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/batch_rasterizer.hpp"
#include "tests/support/gl_session.hpp"
#include "tests/support/symbology_scene.hpp"

namespace tedavis::draw {
namespace {

using test_support::GlSession;

struct QuadSession {
    QuadSession(const std::string& backend, const std::string& device, std::uint32_t width, std::uint32_t height)
        : session(backend, device, width, height),
          block(session.device.budget.find(effects::kSymbology)->bytes),
          arena(block.data(), block.size()) {
        const gl::GlError error = quads.start(session.gl, session.device.budget, arena, kSymbologyVertices);
        EXPECT_EQ(error.sentence.view(), "");
        session.gl.seal();
    }
    ~QuadSession() {
        session.gl.retire();
        quads.destroy(session.gl);
    }
    /// RGBA8, bottom row first, over a plain background.
    std::vector<std::uint8_t> picture() {
        gl::bind_surface(session.gl, *session.surface);
        session.gl->ClearColor(60 / 255.0f, 90 / 255.0f, 120 / 255.0f, 1.0f);
        session.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        quads.draw(session.gl, session.surface->width(), session.surface->height());
        return session.pixels();
    }
    GlSession session;
    std::vector<unsigned char> block;
    base::Arena arena;
    QuadDrawer quads;
};

TEST(QuadDrawer, DrawsWhatTheFormulaSays) {
    for (const char* device : {"es2-small", "es3-mid"})
        for (const auto& [width, height] : {std::pair<std::uint32_t, std::uint32_t>{640, 480}, {384, 512}}) {
            QuadSession gl("egl", device, width, height);
            const SymbologyInput input = test_support::scene_input(test_support::scene_state(47, 5, -12), width, height);
            build_symbology(gl.quads.batch(), input, make_layout(width, height, 96));
            const auto pixels = gl.picture();
            test_support::Picture expected(static_cast<int>(width), static_cast<int>(height), {60, 90, 120});
            rasterize(gl.quads.batch(), expected);
            int different = 0;
            for (std::uint32_t y = 0; y < height; ++y)
                for (std::uint32_t x = 0; x < width; ++x) {
                    const std::uint8_t* pixel = &pixels[4 * (static_cast<std::size_t>(height - 1 - y) * width + x)];
                    const design::Color wanted = expected.at(static_cast<int>(x), static_cast<int>(y));
                    if (std::abs(pixel[0] - wanted.red) > 8 || std::abs(pixel[1] - wanted.green) > 8 ||
                        std::abs(pixel[2] - wanted.blue) > 8)
                        ++different;
                    ASSERT_EQ(pixel[3], 255);
                }
            // Filtering precision and the rules for pixels on shared edges differ; nothing else may.
            EXPECT_LT(different, static_cast<int>(width * height / 1000)) << device;
            EXPECT_EQ(gl.session.gl.denied().total, 0u);
            EXPECT_EQ(gl.session.gl.take_error(), 0u);
        }
}

TEST(QuadDrawer, AnEmptyBatchLeavesThePicture) {
    QuadSession gl("egl", "es3-mid", 64, 48);
    const auto pixels = gl.picture();
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        ASSERT_TRUE(pixels[i] == 60 && pixels[i + 1] == 90 && pixels[i + 2] == 120);
}

TEST(QuadDrawer, RefusesTooSmallABudgetWithTheLinesName) {
    GlSession session("egl", "es3-mid");
    std::vector<unsigned char> little(100);
    base::Arena arena(little.data(), little.size());
    QuadDrawer quads;
    const gl::GlError error = quads.start(session.gl, session.device.budget, arena, kSymbologyVertices);
    EXPECT_NE(error.sentence.view().find("'symbology'"), std::string_view::npos);
}

TEST(QuadDrawer, OsMesaAndEglAgreeBitForBit) {
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const std::string& backend : test_support::headless_backends()) {
        QuadSession gl(backend, "es3-mid", 640, 480);
        build_symbology(gl.quads.batch(), test_support::scene_input(test_support::scene_state(200, -7, 31), 640, 480),
                        make_layout(640, 480, 96));
        pictures.push_back(gl.picture());
    }
    for (const auto& picture : pictures) EXPECT_EQ(picture, pictures.front());
}

}  // namespace
}  // namespace tedavis::draw
