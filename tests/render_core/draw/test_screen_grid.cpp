#include "render_core/draw/screen_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/gl_session.hpp"

namespace tedavis::draw {
namespace {

gl::ProgramSource adding_source() {
    static constexpr const char* kUniforms[] = {"gain"};
    gl::ProgramSource source;
    source.name = "adding";
    source.vertex =
        "VERTEX_IN vec2 position;\nVARYING vec2 at;\nvoid main() { at = 0.5 * position + 0.5; gl_Position = vec4(position, 0.0, "
        "1.0); }\n";
    source.fragment = "VARYING vec2 at;\nuniform float gain;\nvoid main() { FRAGMENT_COLOR = vec4(at * gain, 0.1, 1.0); }\n";
    source.attributes = kScreenAttributes;
    source.uniforms = kUniforms;
    return source;
}

/// Drawn with addition: a pixel that two cells cover, or none, gives itself away.
TEST(ScreenGrid, CoversEveryPixelOnce) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        constexpr std::uint32_t kWidth = 203, kHeight = 117;
        test_support::GlSession session("egl", device, kWidth, kHeight);
        ScreenGrid grid;
        ASSERT_EQ(grid.start(session.gl, session.device.budget).sentence.view(), "");
        auto program = gl::build_program(session.gl, adding_source());
        ASSERT_TRUE(program.ok());
        session.gl.seal();
        session.gl.begin_frame();
        session.gl->ClearColor(0, 0, 0, 0);
        session.gl->Clear(GL_COLOR_BUFFER_BIT);
        session.gl->Enable(GL_BLEND);
        session.gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
        program.value().use(session.gl);
        session.gl->Uniform1f(program.value().uniform(0), 1.0f);
        grid.draw(session.gl);
        const std::vector<std::uint8_t> pixels = session.pixels();
        for (std::size_t n = 0; n < pixels.size(); n += 4) {
            ASSERT_NEAR(pixels[n + 2], 25.5, 0.6) << device << " pixel " << n / 4;
            ASSERT_NEAR(pixels[n], 255.0 * ((n / 4) % kWidth + 0.5) / kWidth, 1.0);
            ASSERT_NEAR(pixels[n + 1], 255.0 * ((n / 4) / kWidth + 0.5) / kHeight, 1.0);
        }
        EXPECT_EQ(session.gl.denied().total, 0u);
        session.gl.retire();
        program.value().destroy(session.gl);
        grid.destroy(session.gl);
    }
}

TEST(ScreenGrid, ADeviceWithoutRoomIsRefused) {
    test_support::GlSession session("egl", "es3-mid");
    base::BudgetLine& line = *session.device.budget.find("symbology_vertices");
    line.use.in_use = line.bytes;
    ScreenGrid grid;
    EXPECT_NE(grid.start(session.gl, session.device.budget).sentence.view(), "");
    session.gl.seal();
    session.gl.retire();
    grid.destroy(session.gl);
}

}  // namespace
}  // namespace tedavis::draw
