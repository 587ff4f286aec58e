#include "render_core/draw/drawers/picture_pass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

#include "render_core/draw/drawers/terrain_program.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_picture_pass {
namespace {

using test_support::GlSession;

constexpr std::uint32_t kWidth = 64, kHeight = 48;
constexpr design::Color kInk{10, 200, 30};

/// Distances over the picture, columns from the left and rows from the top.
using DistanceFormula = std::function<double(int, int)>;

struct Picture {
    std::vector<std::uint8_t> rgba;
    [[nodiscard]] const std::uint8_t* at(int x, int y) const {
        return rgba.data() +
               (static_cast<std::size_t>(static_cast<int>(kHeight) - 1 - y) * kWidth + static_cast<std::size_t>(x)) * 4;
    }
    /// 0 the scene's grey, 1 the ink.
    [[nodiscard]] double ink(int x, int y) const { return (at(x, y)[1] - 100) / (kInk.green - 100.0); }
};

/// A grey picture whose alpha codes the distances as terrain.frag does, bottom row first.
std::vector<std::uint8_t> coded_scene(const DistanceFormula& distance_m) {
    std::vector<std::uint8_t> texels;
    for (int y = static_cast<int>(kHeight) - 1; y >= 0; --y)
        for (int x = 0; x < static_cast<int>(kWidth); ++x) {
            const double code = std::log2(1 + distance_m(x, y) / kDistanceCodeStart_m) / kDistanceCodeOctaves;
            texels.insert(texels.end(), {100, 100, 100, static_cast<std::uint8_t>(std::lround(255 * code))});
        }
    return texels;
}

design::DesignSettings design_with(double silhouettes) {
    design::DesignSettings design = design::default_design_settings();
    design.terrain.style.sketch.silhouettes = silhouettes;
    design.terrain.style.sketch.line = kInk;
    return design;
}

/// Draws the scene off-screen and finishes the pass.
Picture outlined(const DistanceFormula& distance_m, double strength, const char* device = "es3-mid",
                 const ScreenPart& ground = {}) {
    const design::DesignSettings design = design_with(strength);
    GlSession session("egl", device, kWidth, kHeight);
    PicturePass pass;
    EXPECT_FALSE(pass.is_started());
    const DrawnDesign only{&design, TerrainOutput::color_and_distance};
    EXPECT_EQ(pass.start(session.gl, session.device.budget, kWidth, kHeight, {&only, 1}).message.view(), "");
    EXPECT_TRUE(pass.is_started());
    base::BudgetLine line;
    line.bytes = 100'000;
    auto scene = gl::make_texture(session.gl, line, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kWidth, kHeight});
    test_support::ScreenTriangle triangle(session.gl);
    EXPECT_TRUE(scene.value().upload(session.gl, {0, 0, kWidth, kHeight}, coded_scene(distance_m).data()));
    session.gl.seal();
    session.gl.begin_frame();
    pass.begin(session.gl);
    triangle.copy(session.gl, scene.value());
    PictureInput input;
    input.outlined = strength > 0;
    input.ground = ground;
    pass.finish(session.gl, *session.surface, design, input);
    EXPECT_EQ(session.gl.denied().total, 0u);
    EXPECT_EQ(session.gl.take_error(), GLenum{GL_NO_ERROR});
    Picture picture{session.pixels()};
    session.gl.retire();
    triangle.destroy(session.gl);
    scene.value().destroy(session.gl);
    pass.destroy(session.gl);
    return picture;
}

double jump_at_column(int x, double near_m, double far_m) { return x < 32 ? near_m : far_m; }

TEST(PicturePass, AJumpIsInkedInAPixelOnBothSides) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const Picture picture = outlined([](int x, int) { return jump_at_column(x, 1000, 2000); }, 1, device);
        for (int y = 2; y < 46; ++y)
            for (int x = 2; x < 62; ++x)
                EXPECT_NEAR(picture.ink(x, y), x == 31 || x == 32 ? 1 : 0, 0.02) << x << ", " << y << " " << device;
    }
}

TEST(PicturePass, RowsAreLookedAtToo) {
    const Picture picture = outlined([](int, int y) { return y < 20 ? 5000.0 : 800.0; }, 1);
    for (int y = 2; y < 46; ++y) EXPECT_NEAR(picture.ink(30, y), y == 19 || y == 20 ? 1 : 0, 0.02) << y;
}

TEST(PicturePass, AWeakJumpInksTheNearSideMore) {
    const Picture picture = outlined([](int x, int) { return jump_at_column(x, 1000, 1300); }, 1);
    EXPECT_GT(picture.ink(31, 24), 0.6);
    EXPECT_LT(picture.ink(32, 24), 0.8 * picture.ink(31, 24));
    EXPECT_GT(picture.ink(32, 24), 0.05);
}

TEST(PicturePass, ASlopeThatRunsAwayIsNoSilhouette) {
    // The code rises by up to four steps a pixel, evenly: ground seen at a grazing angle.
    const auto slope = [](double steps) {
        return [steps](int x, int) {
            return kDistanceCodeStart_m * (std::exp2((0.2 + x * steps / 255) * kDistanceCodeOctaves) - 1);
        };
    };
    for (const double steps : {0.3, 1.0, 2.0, 3.0}) {
        const Picture picture = outlined(slope(steps), 1);
        for (int x = 2; x < 62; ++x) EXPECT_NEAR(picture.ink(x, 24), 0, 0.02) << x << " at " << steps;
    }
}

TEST(PicturePass, TheJumpIsJudgedByItsShareOfTheDistance) {
    const auto most_ink = [](double near_m, double far_m) {
        return outlined([&](int x, int) { return jump_at_column(x, near_m, far_m); }, 1).ink(31, 24);
    };
    EXPECT_NEAR(most_ink(1000, 1050), 0, 0.02) << "five percent are a fold of the ground";
    EXPECT_NEAR(most_ink(1000, 1500), 1, 0.02);
    EXPECT_NEAR(most_ink(20000, 21000), 0, 0.02);
    EXPECT_NEAR(most_ink(20000, 30000), 1, 0.02) << "the same share far away";
}

TEST(PicturePass, TheStrengthMixesTheInkAndTheSceneStaysElse) {
    const auto scene = [](int x, int) { return jump_at_column(x, 1000, 3000); };
    EXPECT_NEAR(outlined(scene, 0.5).ink(31, 24), 0.5, 0.02);
    const Picture none = outlined(scene, 0);
    for (std::size_t n = 0; n < none.rgba.size(); n += 4) {
        EXPECT_EQ(none.rgba[n], 100);
        EXPECT_EQ(none.rgba[n + 3], 255) << "the code does not reach the surface";
    }
}

TEST(PicturePass, WhereNothingWasDrawnIsTheSky) {
    constexpr std::uint32_t kWide = 512, kHigh = 384;
    const design::DesignSettings design = design_with(1);
    for (const char* device : {"es3-mid", "es2-small"}) {
        GlSession session("egl", device, kWide, kHigh);
        PicturePass pass;
        SkyDrawer sky;
        const DrawnDesign only{&design, TerrainOutput::code};
        ASSERT_EQ(pass.start(session.gl, session.device.budget, kWide, kHigh, {&only, 1}).message.view(), "");
        ASSERT_EQ(sky.start(session.gl, session.device.budget).message.view(), "");
        session.gl.seal();
        session.gl.begin_frame();
        PictureInput input;
        input.outlined = true;
        input.sky.view = make_view_frame(kWide, kHigh, 1, 0.3, 0.1, 0.2);
        input.sky.colors = design.sky;
        pass.begin(session.gl);
        pass.finish(session.gl, *session.surface, design, input);
        const std::vector<std::uint8_t> alone = session.pixels();
        session.gl->Clear(GL_DEPTH_BUFFER_BIT);
        sky.draw(session.gl, input.sky);
        const std::vector<std::uint8_t> drawn = session.pixels();
        int most = 0;
        for (std::size_t n = 0; n < drawn.size(); ++n) most = std::max(most, std::abs(int{alone[n]} - int{drawn[n]}));
        EXPECT_LE(most, 2) << device << ": the table has 128 steps of sky and 64 over the horizon's pixels";
        EXPECT_EQ(session.gl.denied().total, 0u);
        session.gl.retire();
        sky.destroy(session.gl);
        pass.destroy(session.gl);
    }
}

/// Scene and silhouettes below, sky above: the part that is said to be empty is not looked at.
TEST(PicturePass, BeyondTheGroundsPartIsSkyWhateverWasDrawnThere) {
    const auto scene = [](int x, int) { return jump_at_column(x, 1000, 3000); };
    const Picture whole = outlined(scene, 1), below = outlined(scene, 1, "es3-mid", {0, 1, 0});
    for (int y = 24; y < 48; ++y)
        for (int x = 0; x < 64; ++x) ASSERT_EQ(whole.at(x, y)[1], below.at(x, y)[1]) << x << ", " << y;
    for (int x = 0; x < 64; ++x) {
        EXPECT_NE(below.at(x, 4)[2], 100) << "the scene's grey";
        EXPECT_EQ(below.at(x, 4)[2], below.at(0, 4)[2]) << "no ink";
    }
}

TEST(PicturePass, ADeviceWithoutRoomIsRefused) {
    GlSession session("egl", "es3-mid", kWidth, kHeight);
    session.device.budget.find(effects::kRenderTargets)->use.in_use = session.device.budget.find(effects::kRenderTargets)->bytes;
    PicturePass pass;
    const design::DesignSettings design = design_with(1);
    const DrawnDesign only{&design, TerrainOutput::color_and_distance};
    const base::Error error = pass.start(session.gl, session.device.budget, kWidth, kHeight, {&only, 1});
    EXPECT_NE(error.message.view(), "");
    EXPECT_FALSE(pass.is_started());
    session.gl.seal();
    session.gl.retire();
    pass.destroy(session.gl);
}

}  // namespace
}  // namespace tedavis::draw::test_picture_pass
