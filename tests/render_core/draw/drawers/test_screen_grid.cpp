#include "render_core/draw/drawers/screen_grid.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_screen_grid {
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

constexpr std::uint32_t kWidth = 203, kHeight = 117;

/// Draws with addition: a pixel that two cells cover, or none, gives itself away.
class AddedGrid {
public:
    explicit AddedGrid(const char* device) : session_("egl", device, kWidth, kHeight) {
        EXPECT_EQ(grid_.start(session_.gl, session_.device.budget).message.view(), "");
        auto program = gl::build_program(session_.gl, adding_source());
        EXPECT_TRUE(program.ok());
        program_ = program.value();
        session_.gl.seal();
    }
    ~AddedGrid() {
        EXPECT_EQ(session_.gl.denied().total, 0u);
        session_.gl.retire();
        program_.destroy(session_.gl);
        grid_.destroy(session_.gl);
    }
    AddedGrid(const AddedGrid&) = delete;
    AddedGrid& operator=(const AddedGrid&) = delete;

    /// RGBA, bottom row first; blue says how often a pixel was covered.
    std::vector<std::uint8_t> pixels(const std::function<void(gl::Gl&, const ScreenGrid&)>& draw) {
        session_.gl.begin_frame();
        session_.gl->ClearColor(0, 0, 0, 0);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT);
        session_.gl->Enable(GL_BLEND);
        session_.gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
        program_.use(session_.gl);
        session_.gl->Uniform1f(program_.uniform(0), 1.0f);
        draw(session_.gl, grid_);
        return session_.pixels();
    }
    /// Of the cells that reach into the part.
    std::vector<std::uint8_t> inside(const ScreenPart& part) {
        return pixels([&](gl::Gl& gl, const ScreenGrid& grid) { grid.draw_cells(gl, part, true); });
    }

private:
    test_support::GlSession session_;
    ScreenGrid grid_;
    gl::Program program_;
};

double covered_share(const std::vector<std::uint8_t>& pixels) {
    std::size_t covered = 0;
    for (std::size_t n = 0; n < pixels.size(); n += 4) covered += pixels[n + 2] > 0 ? 1 : 0;
    return static_cast<double>(covered) / (kWidth * kHeight);
}

void expect_covered_once(const std::vector<std::uint8_t>& pixels) {
    for (std::size_t n = 0; n < pixels.size(); n += 4) ASSERT_NEAR(pixels[n + 2], 25.5, 0.6) << "pixel " << n / 4;
}

constexpr float kInfinite = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
constexpr ScreenPart kParts[] = {{0, 1, 0.1f}, {0.3f, 0.7f, -0.2f}, {-0.6f, 0.2f, 0.3f}, {0.5f, -0.5f, 0}, {0, -1, 0.44f}};

TEST(ScreenGrid, CoversEveryPixelOnce) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        const auto pixels = AddedGrid(device).pixels([](gl::Gl& gl, const ScreenGrid& grid) { grid.draw(gl); });
        expect_covered_once(pixels);
        for (std::size_t n = 0; n < pixels.size(); n += 4) {
            ASSERT_NEAR(pixels[n], 255.0 * ((n / 4) % kWidth + 0.5) / kWidth, 1.0) << device;
            ASSERT_NEAR(pixels[n + 1], 255.0 * ((n / 4) / kWidth + 0.5) / kHeight, 1.0) << device;
        }
    }
}

TEST(ScreenGrid, APartAndTheRestCoverEveryPixelOnce) {
    AddedGrid added("es3-mid");
    for (const ScreenPart& part : {kParts[0], kParts[1], kParts[2], kParts[3], kParts[4], ScreenPart{0, 1, -kInfinite},
                                   ScreenPart{0, 1, kInfinite}, ScreenPart{kNan, 1, 0}})
        expect_covered_once(added.pixels([&](gl::Gl& gl, const ScreenGrid& grid) {
            grid.draw_cells(gl, part, true);
            grid.draw_cells(gl, part, false);
        }));
}

TEST(ScreenGrid, APartHoldsAllOfItsPixelsAndFewOthers) {
    AddedGrid added("es3-mid");
    for (const ScreenPart& part : kParts) {
        const auto within = added.inside(part);
        for (std::size_t n = 0; n < within.size() / 4; ++n) {
            const float x = 2.0f * (static_cast<float>(n % kWidth) + 0.5f) / kWidth - 1,
                        y = 2.0f * (static_cast<float>(n / kWidth) + 0.5f) / kHeight - 1;
            const bool is_in_part = x * part.right + y * part.up <= part.limit;
            ASSERT_TRUE(within[4 * n + 2] > 0 || !is_in_part) << x << ", " << y;
        }
        EXPECT_LT(covered_share(within), 0.85) << part.right << ", " << part.up;
    }
}

TEST(ScreenGrid, WhatIsNotKnownIsTheWholeScreen) {
    AddedGrid added("es3-mid");
    EXPECT_EQ(covered_share(added.inside({0, 1, kInfinite})), 1);
    EXPECT_EQ(covered_share(added.inside({kNan, 1, 0})), 1);
    EXPECT_EQ(covered_share(added.inside({0, 1, kNan})), 1);
    EXPECT_EQ(covered_share(added.inside({0, 1, -kInfinite})), 0) << "control: nothing was drawn";
}

TEST(ScreenGrid, ADeviceWithoutRoomIsRefused) {
    test_support::GlSession session("egl", "es3-mid");
    base::BudgetLine& line = *session.device.budget.find("symbology_vertices");
    line.use.in_use = line.bytes;
    ScreenGrid grid;
    EXPECT_NE(grid.start(session.gl, session.device.budget).message.view(), "");
    session.gl.seal();
    session.gl.retire();
    grid.destroy(session.gl);
}

}  // namespace
}  // namespace tedavis::draw::test_screen_grid
