#include "render_core/draw/drawers/light_shafts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/draw/drawers/data/solid_casters.hpp"
#include "render_core/draw/drawers/view_effects_pass.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_light_shafts {
namespace {

constexpr std::uint32_t kWidth = 64, kHeight = 48;
constexpr double kLatitude = 0.8203, kLongitude = 0.1745;  // near 47 N 10 E
constexpr double kHaze_per_m = 1 / 4000.0;

/// An eye that looks level to the north through the shade of plates, the sun in the zenith.
class LightShaftsInHaze : public ::testing::Test {
protected:
    LightShaftsInHaze() : block_(1u << 22) {
        base::Arena arena(block_.data(), block_.size());
        base::BudgetTable& budget = session_.device.budget;
        base::BudgetLine& targets = *budget.find(effects::kRenderTargets);
        EXPECT_EQ(map_.start(session_.gl, targets, 1024).message.view(), "");
        EXPECT_EQ(shafts_.start(session_.gl, budget, kWidth, kHeight, false).message.view(), "");
        EXPECT_EQ(casters_.start(session_.gl).message.view(), "");
        EXPECT_TRUE(
            solids_.start(session_.gl, *budget.find(effects::kSceneSolidVertices), arena, {64, 192, 8}, gl::BufferUse::streamed)
                .message.empty());
        EXPECT_TRUE(mesh_.start(arena));
        auto scene =
            gl::make_texture(session_.gl, targets, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kWidth, kHeight});
        scene_ = static_cast<gl::Texture&&>(scene.value());
        EXPECT_EQ(pass_.start(session_.gl, budget, kWidth, kHeight, {false, false, true}).message.view(), "");
        session_.gl.seal();
        view_ = test_support::free_view(earth::to_ecef({kLatitude, kLongitude, {1000}}),
                                        earth::body_axes(kLatitude, kLongitude, 0, 0, 0), kWidth, kHeight, 10);
    }
    ~LightShaftsInHaze() override {
        session_.gl.retire();
        scene_.destroy(session_.gl);
        pass_.destroy(session_.gl);
        shafts_.destroy(session_.gl);
        casters_.destroy(session_.gl);
        solids_.destroy(session_.gl);
        map_.destroy(session_.gl);
    }
    /// Level, 500 m over the eye.
    void add_plate(double from_m, double to_m, std::uint8_t alpha = 255) {
        const glm::dmat3 down = earth::north_east_down(kLatitude, kLongitude);
        const auto corner = [&](double north_m, double east_m) { return view_.eye + down * glm::dvec3(north_m, east_m, -500); };
        mesh_.begin(corner(from_m, 0));
        mesh_.set_color({1, 2, 3, alpha});
        mesh_.quad(corner(from_m, -900), corner(from_m, 900), corner(to_m, 900), corner(to_m, -900));
        EXPECT_TRUE(mesh_.add_to(solids_.batch()));
    }
    void fill_scene(std::uint8_t grey, std::uint8_t code) {
        std::vector<std::uint8_t> texels;
        for (std::uint32_t n = 0; n < kWidth * kHeight; ++n) texels.insert(texels.end(), {grey, grey, grey, code});
        EXPECT_TRUE(scene_.upload(session_.gl, {0, 0, kWidth, kHeight}, texels.data()));
        pass_.target().bind(session_.gl);
        session_.gl->ClearColor(float(grey) / 255, float(grey) / 255, float(grey) / 255, float(code) / 255);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT);
    }
    /// The middle of the picture after shafts were taken off it; a mean of four pixels.
    double seen(std::uint8_t grey, std::uint8_t code, const design::Color& haze = {200, 200, 200}) {
        fill_scene(grey, code);
        ShadowFrame frame = make_shadow_frame({view_, 1000, 0, base::radians(89.99), 1024});
        for (const SolidPiece& piece : solids_.batch().pieces())
            add_caster(frame, {piece.anchor, double{piece.radius_m}, double{piece.top_m}});
        EXPECT_TRUE(solids_.upload(session_.gl));
        const SolidBuffers* const all[] = {&solids_};
        for (std::size_t n = 0; n < kShadowLevels; ++n) {
            map_.begin_level(session_.gl, n);
            casters_.draw(session_.gl, all, {~0u, 0}, {frame, n, texel_m(frame.levels[n], 1024), view_.eye});
        }
        map_.end(session_.gl);
        shafts_.draw(session_.gl, {view_, scene_, {&map_.texture(), &frame, frame.top_m + 30}, {}, kHaze_per_m, haze, 1, 64});
        ViewEffectsInput effects;
        effects.shafts = &shafts_.texture();
        pass_.finish(session_.gl, *session_.surface, effects);
        EXPECT_EQ(session_.gl.take_error(), 0u);
        EXPECT_EQ(session_.gl.denied().total, 0u);
        pixels_ = session_.pixels();
        double sum = 0;
        for (const std::uint32_t y : {23u, 24u})
            for (const std::uint32_t x : {31u, 32u}) sum += pixels_[(std::size_t{y} * kWidth + x) * 4];
        return sum / 4;
    }
    static double lost(double from_m, double to_m) {
        return 200 * (std::exp(-from_m * kHaze_per_m) - std::exp(-to_m * kHaze_per_m));
    }

    test_support::GlSession session_{"egl", "es3-mid", kWidth, kHeight};
    std::vector<unsigned char> block_;
    ShadowMap map_;
    SolidCasters casters_;
    test_support::FilledSolids solids_;
    SolidMesh mesh_;
    LightShafts shafts_;
    ViewEffectsPass pass_;
    gl::Texture scene_;
    terrain::View view_;
    std::vector<std::uint8_t> pixels_;
};

std::uint8_t code_of(double distance_m) { return static_cast<std::uint8_t>(std::lround(255 * distance_code(distance_m))); }

/// By hand: the light of a medium of one density between the shade's beginning and its end.
TEST_F(LightShaftsInHaze, ARayLosesTheLightOfItsPartInShade) {
    add_plate(800, 2000);
    EXPECT_NEAR(seen(220, 255), 220 - lost(800, 2000), 2.5);
    solids_.batch().clear();
    add_plate(3000, 3500);
    EXPECT_NEAR(seen(220, 255), 220 - lost(3000, 3500), 2.5);
    solids_.batch().clear();
    add_plate(800, 2000, 128);
    EXPECT_NEAR(seen(220, 255), 220 - 0.5 * lost(800, 2000), 2.5) << "half as dense";
}

TEST_F(LightShaftsInHaze, NothingBehindWhatIsSeenCounts) {
    add_plate(800, 2000);
    EXPECT_NEAR(seen(220, code_of(1400)), 220 - lost(800, 1400), 4) << "within a step of the distance's code";
    EXPECT_EQ(seen(220, code_of(700)), 220);
}

TEST_F(LightShaftsInHaze, WithoutCastersEveryPixelStaysAsItIs) {
    EXPECT_EQ(seen(123, 255), 123);
    for (std::size_t n = 0; n < pixels_.size(); n += 4) ASSERT_EQ(pixels_[n], 123);
}

TEST_F(LightShaftsInHaze, WarningsLoseNothing) {
    add_plate(100, 3000);
    EXPECT_LT(seen(220, 255), 200) << "control";
    EXPECT_EQ(seen(220, 0), 220) << "a distance of nothing stands for them";
}

TEST_F(LightShaftsInHaze, NoMoreIsTakenThanWasAdded) {
    add_plate(100, 3000);
    EXPECT_EQ(seen(10, 255), 0) << "never below black";
    EXPECT_EQ(seen(220, 255, {0, 0, 0}), 220) << "black haze adds nothing";
}

TEST_F(LightShaftsInHaze, APictureIsTheSameEveryTime) {
    add_plate(800, 2000);
    static_cast<void>(seen(220, 255));
    const std::vector<std::uint8_t> first = pixels_;
    static_cast<void>(seen(220, 255));
    EXPECT_EQ(pixels_, first);
}

}  // namespace
}  // namespace tedavis::draw::test_light_shafts
