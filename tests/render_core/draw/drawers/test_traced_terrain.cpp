#include "render_core/draw/drawers/traced_terrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/gl/render_target.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/raytrace/traced_file.hpp"

namespace tedavis::draw::test_traced_terrain {
namespace {

using design::TerrainRenderer;
using test_support::OpenedGround;

constexpr std::uint32_t kWidth = 160, kHeight = 120;
constexpr std::uint64_t kMemory = 4 << 20;

/// A design that codes can show, by rays.
design::DesignSettings traced_design() {
    design::DesignSettings design = design::default_design_settings();
    design.terrain.renderer = TerrainRenderer::trace;
    return design;
}

struct Stage {
    explicit Stage(const test_support::TdbSpec& spec, const char* device = "es3-mid", std::uint64_t bytes = kMemory)
        : of(spec), at("egl", device, kWidth, kHeight), memory(bytes / 8 + 1), arena(memory.data(), bytes) {
        error = terrain.start(at.gl, of.database, of.query, at.device, {nullptr, &arena, kWidth, kHeight});
        const gl::TextureSettings texels{gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kWidth, kHeight};
        target = std::move(
            gl::make_render_target(at.gl, *at.device.budget.find(effects::kRenderTargets), texels, gl::TargetDepth::bits24)
                .value());
        at.gl.seal();
        at.gl.begin_frame();
    }
    ~Stage() {
        at.gl.retire();
        terrain.destroy(at.gl);
        target.destroy(at.gl);
    }
    [[nodiscard]] TerrainDrawInput input(const terrain::View& view) const {
        TerrainDrawInput drawn;
        drawn.view = view;
        drawn.light_direction[0] = glm::normalize(view.eye);
        drawn.heights = {400, 1200};
        return drawn;
    }
    /// Of the target, rows from the bottom.
    [[nodiscard]] std::vector<std::uint8_t> pixels() {
        target.bind(at.gl);
        return at.pixels();
    }

    OpenedGround of;
    test_support::GlSession at;
    std::vector<std::uint64_t> memory;
    base::Arena arena;
    TracedTerrain terrain;
    gl::RenderTarget target;
    base::Error error;
};

terrain::View small_view(const Stage& stage, double heading_deg, double pitch_deg) {
    terrain::View view = test_support::view_from(stage.of.tdb, 80, 64, 700, heading_deg, pitch_deg, 10);
    view.focal_px *= static_cast<double>(kWidth) / view.width;
    view.width = kWidth;
    view.height = kHeight;
    return view;
}

TEST(TracedTerrain, PutsCodesAndLeavesDepthsOfWhatRaysMeet) {
    Stage stage(test_support::coast_file());
    ASSERT_EQ(stage.error.message.view(), "");
    ASSERT_EQ(stage.terrain.state(), TraceState::traced);
    const TerrainDrawInput input = stage.input(small_view(stage, 40, -15));
    ASSERT_TRUE(can_trace(stage.of.database, input.view));
    stage.terrain.draw(stage.at.gl, traced_design(), input, stage.target.color());
    const std::vector<std::uint8_t> codes = stage.pixels();

    // Where the depth that is left is nearer than a plane's, the pixel is white.
    const DepthRange range{100, 50000};
    for (const double plane_m : {1500.0, 3000.0, 6000.0}) {
        stage.target.bind(stage.at.gl);
        stage.at.gl->ClearColor(0, 0, 0, 1);
        stage.at.gl->ClearDepthf(
            static_cast<float>(range.far_m * (plane_m - range.near_m) / ((range.far_m - range.near_m) * plane_m)));
        stage.at.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        stage.at.gl->Enable(GL_DEPTH_TEST);
        stage.terrain.draw_depths(stage.at.gl, input, range);
        stage.at.gl->ClearDepthf(1);
        const std::vector<std::uint8_t> white = stage.pixels();
        int nearer = 0, farther = 0, wrong = 0;
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x) {
                const std::size_t at = 4 * (std::size_t{y} * kWidth + x);
                const double stretch = std::sqrt(1 + std::pow((x + 0.5 - 80) / input.view.focal_px, 2) +
                                                 std::pow((y + 0.5 - 60) / input.view.focal_px, 2));
                const double depth_m = 50 * (std::exp2(13 * codes[at + 3] / 255.0) - 1) / stretch;
                if (std::abs(depth_m / plane_m - 1) < 0.03) continue;  // codes are that coarse
                const bool is_nearer = codes[at + 3] != kNothingCode && depth_m < plane_m;
                ++(is_nearer ? nearer : farther);
                wrong += (white[at] == 255) != is_nearer ? 1 : 0;
            }
        EXPECT_EQ(wrong, 0) << plane_m;
        EXPECT_GT(nearer, 500) << plane_m;
        EXPECT_GT(farther, 500) << plane_m;
    }
    EXPECT_EQ(stage.at.gl.denied().total, 0u);
}

TEST(TracedTerrain, TracesAnewForAnotherViewOnly) {
    Stage stage(test_support::coast_file());
    const auto codes = [&](const terrain::View& view) {
        stage.terrain.draw(stage.at.gl, traced_design(), stage.input(view), stage.target.color());
        return stage.pixels();
    };
    const auto first = codes(small_view(stage, 40, -15)), turned = codes(small_view(stage, 41, -15));
    EXPECT_NE(first, turned);
    EXPECT_EQ(codes(small_view(stage, 40, -15)), first);
}

TEST(TracedTerrain, SaysWhatKeepsItFromTracing) {
    EXPECT_EQ(Stage(test_support::coast_file(), "es2-small").terrain.state(), TraceState::not_on_lane);
    EXPECT_EQ(Stage(test_support::coast_file(), "es3-mid", 1000).terrain.state(), TraceState::not_on_device);
    EXPECT_EQ(Stage(test_support::coast_file(), "es3-mid", 500'000).terrain.state(), TraceState::database_too_large);
    test_support::TdbSpec earth = test_support::whole_earth(128, 65);
    earth.height_m = [](std::uint32_t, std::uint32_t) { return 100.0; };
    earth.measured = false;
    EXPECT_EQ(Stage(earth).terrain.state(), TraceState::database_round);
}

}  // namespace
}  // namespace tedavis::draw::test_traced_terrain
