#include "render_core/display/scene_passes.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "tests/support/programs/gl_session.hpp"

namespace tedavis::display::test_scene_passes {
namespace {

using test_support::GlSession;

constexpr std::uint32_t kWidth = 64, kHeight = 48;

class ScenePassesStart : public ::testing::Test {
protected:
    [[nodiscard]] std::uint64_t target_bytes() { return session_.device.budget.find(effects::kRenderTargets)->use.in_use; }
    [[nodiscard]] draw::DrawnDesign drawn() const { return {&design_, draw::output_of(design_, true)}; }
    [[nodiscard]] base::Error start() {
        const draw::DrawnDesign only = drawn();
        return passes_.start(session_.gl, session_.device, {&only, 1}, kWidth, kHeight);
    }

    GlSession session_{"egl", "es3-mid", kWidth, kHeight};
    design::DesignSettings design_ = design::default_design_settings();
    ScenePasses passes_;
};

TEST_F(ScenePassesStart, TakesPicturesOffScreenOnlyForStylesThatNeedThem) {
    design_.terrain.style.texture = design::TerrainTexture::slope;
    design_.terrain.style.sketch.silhouettes = 0;
    ASSERT_EQ(start().message.view(), "");
    EXPECT_EQ(drawn().output, draw::TerrainOutput::color);
    EXPECT_EQ(target_bytes(), 0u);
    passes_.destroy(session_.gl);
}

TEST_F(ScenePassesStart, PaysForThemAndGivesThemBack) {
    design_.terrain.style.sketch.silhouettes = 1;
    ASSERT_EQ(start().message.view(), "");
    EXPECT_NE(drawn().output, draw::TerrainOutput::color);
    EXPECT_GE(target_bytes(), std::uint64_t{kWidth} * kHeight * 8) << "colour and depth";
    passes_.destroy(session_.gl);
    EXPECT_EQ(target_bytes(), 0u);
}

TEST_F(ScenePassesStart, EffectsThatWereNotBuiltAreNotShown) {
    design_.effects.antialiasing = design::Antialiasing::on;
    ASSERT_EQ(start().message.view(), "");
    EXPECT_TRUE(passes_.shows(drawn()));
    design_.effects.antialiasing = design::Antialiasing::off;
    EXPECT_TRUE(passes_.shows(drawn())) << "less is no matter";
    design_.effects.depth_of_field.blur_px = 2;
    EXPECT_FALSE(passes_.shows(drawn()));
    design_.effects.depth_of_field.blur_px = 0;
    design_.sky.air.is_shown = true;
    EXPECT_FALSE(passes_.shows(drawn()));
    passes_.destroy(session_.gl);
}

/// Undecided, it is off: a display's designs are those that possible_design() returns.
TEST_F(ScenePassesStart, SmoothsOnlyWhatIsDecided) {
    design_.effects.antialiasing = design::Antialiasing::by_device;
    ASSERT_EQ(start().message.view(), "");
    EXPECT_TRUE(passes_.shows(drawn()));
    design_.effects.antialiasing = design::Antialiasing::on;
    EXPECT_FALSE(passes_.shows(drawn())) << "it was not built";
    passes_.destroy(session_.gl);
}

TEST_F(ScenePassesStart, AMapOfShadowsIsPaidForWhereADesignAsksForThem) {
    design_.terrain.style.sketch.silhouettes = 0;
    design_.terrain.style.texture = design::TerrainTexture::slope;
    design_.effects.shadows.on_ground = 0.5;
    ASSERT_EQ(start().message.view(), "");
    EXPECT_EQ(drawn().output, draw::TerrainOutput::color) << "read where the ground is drawn";
    EXPECT_EQ(target_bytes(), std::uint64_t{1024} * 1024 * 3 * 8);
    design_.effects.shadows.in_air = 0.5;
    EXPECT_FALSE(passes_.shows(drawn())) << "shafts of light were not built";
    passes_.destroy(session_.gl);
    EXPECT_EQ(target_bytes(), 0u);
}

TEST_F(ScenePassesStart, ShaftsOfLightTakeAPictureAndAQuarterOfOneBesides) {
    design_.terrain.style.sketch.silhouettes = 0;
    design_.terrain.style.texture = design::TerrainTexture::slope;
    design_.effects.shadows.in_air = 0.5;
    ASSERT_EQ(start().message.view(), "");
    EXPECT_EQ(drawn().output, draw::TerrainOutput::color_and_distance);
    EXPECT_EQ(target_bytes(), std::uint64_t{1024} * 1024 * 3 * 8 + std::uint64_t{kWidth} * kHeight * (8 + 1));
    passes_.destroy(session_.gl);
}

TEST_F(ScenePassesStart, DesignsThatFollowOneAnotherHaveTheProgramsOfAll) {
    design::DesignSettings lined = design_, colored = design_, blurred = design_;
    lined.terrain.style.sketch.silhouettes = 1;
    colored.terrain.style.texture = design::TerrainTexture::slope;
    colored.terrain.style.sketch.silhouettes = 0;
    blurred.effects.depth_of_field.blur_px = 2;
    draw::DrawnDesign designs[] = {{&colored}, {&lined}, {&blurred}};
    for (draw::DrawnDesign& one : designs) one.output = draw::output_of(*one.design, true);
    ASSERT_NE(designs[1].output, designs[0].output);
    ASSERT_EQ(passes_.start(session_.gl, session_.device, designs, kWidth, kHeight).message.view(), "");
    for (const draw::DrawnDesign& one : designs) {
        EXPECT_TRUE(passes_.shows(one));
        passes_.set_design(one);
    }
    colored.effects.shadows.on_ground = 1;
    EXPECT_FALSE(passes_.shows({&colored}));
    passes_.destroy(session_.gl);
}

TEST_F(ScenePassesStart, SaysWhichBudgetHasNoRoom) {
    design_.terrain.style.sketch.silhouettes = 1;
    base::BudgetLine* const line = session_.device.budget.find(effects::kRenderTargets);
    line->bytes = line->use.capacity = 1000;
    EXPECT_NE(start().message.view().find("render_targets"), std::string_view::npos);
    passes_.destroy(session_.gl);
}

TEST_F(ScenePassesStart, WithoutTerrainThereIsNothingButSky) {
    ASSERT_EQ(start().message.view(), "");
    policy::DisplayDecisions decisions;
    decisions.plain_horizon = true;
    CameraInput level;
    level.own_ship = {0.8, 0.2, {1000}};
    level.width_px = kWidth;
    level.height_px = kHeight;
    const Camera camera = make_camera(level, design_.view, 0);
    const FrameRecord record;
    const DrawContext frame{design_, decisions, camera, record};
    const auto terrain = std::make_unique<TerrainPainter>();
    const SeenTerrain nothing;
    const auto elements = std::make_unique<ElementPainter>();
    EffectWorkTable work;
    session_.gl.seal();
    session_.gl.begin_frame();
    gl::bind_surface(session_.gl, *session_.surface);
    const draw::TerrainDrawResult drawn =
        passes_.draw(session_.gl, *session_.surface, {frame, {}, *terrain, nothing, *elements, {}, {}, work});
    EXPECT_EQ(drawn.draws, 0u);
    const auto pixels = session_.pixels();
    const std::uint8_t* const top = pixels.data() + (std::size_t{kWidth} * kHeight - kWidth / 2) * 4;
    EXPECT_GT(top[2], top[0]) << "blue above";
    EXPECT_NE(std::memcmp(top, pixels.data(), 3), 0) << "another colour below";
    passes_.destroy(session_.gl);
}

}  // namespace
}  // namespace tedavis::display::test_scene_passes
