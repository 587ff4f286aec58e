#include "render_core/draw/screen_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

TEST(ScreenGrid, APartAndTheRestAreTheWholeAndThePartHoldsAllOfIts) {
    constexpr std::uint32_t kWidth = 203, kHeight = 117;
    test_support::GlSession session("egl", "es3-mid", kWidth, kHeight);
    ScreenGrid grid;
    ASSERT_EQ(grid.start(session.gl, session.device.budget).sentence.view(), "");
    auto program = gl::build_program(session.gl, adding_source());
    ASSERT_TRUE(program.ok());
    session.gl.seal();
    const auto cover = [&](const ScreenPart& part, bool inside, bool outside) {
        session.gl.begin_frame();
        session.gl->ClearColor(0, 0, 0, 0);
        session.gl->Clear(GL_COLOR_BUFFER_BIT);
        session.gl->Enable(GL_BLEND);
        session.gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
        program.value().use(session.gl);
        session.gl->Uniform1f(program.value().uniform(0), 1.0f);
        if (inside) grid.draw_cells(session.gl, part, true);
        if (outside) grid.draw_cells(session.gl, part, false);
        return session.pixels();
    };
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    const ScreenPart parts[] = {{0, 1, 0.1f},   {0.3f, 0.7f, -0.2f}, {-0.6f, 0.2f, 0.3f}, {0.5f, -0.5f, 0},
                                {0, -1, 0.44f}, {0, 1, -inf},        {0, 1, inf},         {nan, 1, 0}};
    for (const ScreenPart& part : parts) {
        const auto both = cover(part, true, true), within = cover(part, true, false);
        std::size_t covered = 0;
        for (std::size_t n = 0; n < both.size(); n += 4) {
            ASSERT_NEAR(both[n + 2], 25.5, 0.6) << "pixel " << n / 4;
            const float x = 2.0f * (static_cast<float>((n / 4) % kWidth) + 0.5f) / kWidth - 1,
                        y = 2.0f * (static_cast<float>((n / 4) / kWidth) + 0.5f) / kHeight - 1;
            const bool is_drawn = within[n + 2] > 0;
            if (x * part.right + y * part.up <= part.limit) {
                ASSERT_TRUE(is_drawn) << x << ", " << y;
            }
            covered += is_drawn ? 1 : 0;
        }
        const double share = static_cast<double>(covered) / (kWidth * kHeight);
        if (std::isfinite(part.limit) && !std::isnan(part.right)) {
            EXPECT_LT(share, 0.85) << part.right << ", " << part.up;
        }
        if (part.limit == -inf) {
            EXPECT_EQ(covered, 0u);
        }
        if (std::isnan(part.right)) {
            EXPECT_EQ(share, 1) << "what is not known is the whole screen";
        }
    }
    session.gl.retire();
    program.value().destroy(session.gl);
    grid.destroy(session.gl);
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
