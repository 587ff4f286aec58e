#include "render_core/draw/drawers/quad_drawer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/symbology_scene.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::draw::test_quad_drawer {
namespace {

using test_support::GlSession;

struct QuadSession {
    QuadSession(const std::string& backend, const std::string& device, std::uint32_t width, std::uint32_t height,
                bool with_links = false)
        : session(backend, device, width, height),
          block(session.device.budget.find(effects::kSymbology)->bytes),
          arena(block.data(), block.size()) {
        EXPECT_TRUE(quads.take(arena, kSymbologyVertices));
        EXPECT_EQ(quads.start(session.gl, session.device.budget, quads.batch()).message.view(), "");
        if (with_links) start_links();
        session.gl.seal();
    }
    ~QuadSession() {
        session.gl.retire();
        quads.destroy(session.gl);
        signs.destroy(session.gl);
        links.destroy(session.gl);
    }
    void start_links() {
        billboard_block.resize(session.device.budget.find(effects::kSceneBillboards)->bytes);
        base::Arena own(billboard_block.data(), billboard_block.size());
        base::BudgetTable& budget = session.device.budget;
        EXPECT_TRUE(links.take(own, max_link_vertices(budget)) && signs.take(own, max_sign_vertices(budget)));
        EXPECT_EQ(links.start_links(session.gl, budget, links.batch()).message.view(), "");
        EXPECT_EQ(signs.start_signs(session.gl, budget, signs.batch(), quads).message.view(), "");
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
    test_support::FilledQuads quads;
    std::vector<unsigned char> billboard_block;
    test_support::FilledQuads links, signs;
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
    std::vector<unsigned char> block(session.device.budget.find(effects::kSymbology)->bytes);
    base::Arena arena(block.data(), block.size());
    test_support::FilledQuads quads;
    ASSERT_TRUE(quads.take(arena, kSymbologyVertices));
    session.device.budget.find(effects::kSymbologyVertices)->bytes = 100;
    const base::Error error = quads.start(session.gl, session.device.budget, quads.batch());
    EXPECT_NE(error.message.view().find("'symbology_vertices'"), std::string_view::npos);
    quads.destroy(session.gl);
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

/// Links before a wall so far away, drawn range by range as the display does.
struct LinkSession : QuadSession {
    explicit LinkSession(const std::string& device) : QuadSession("egl", device, 64, 48, true) {}

    static float window_depth(double distance_m, const DepthRange& range) {
        const double n = range.near_m, f = range.far_m;
        return static_cast<float>(0.5 + 0.5 * ((f + n) - 2 * f * n / distance_m) / (f - n));
    }
    /// Red, in the middle of the picture.
    std::uint8_t middle(double wall_m, const DepthPlan& plan) {
        gl::bind_surface(session.gl, *session.surface);
        session.gl->ClearColor(0, 0, 0, 1);
        session.gl->Clear(GL_COLOR_BUFFER_BIT);
        session.gl->Enable(GL_DEPTH_TEST);
        EXPECT_TRUE(links.upload(session.gl));
        for (std::size_t n = 0; n < plan.count; ++n) {
            const float depth = window_depth(wall_m, plan.ranges[n]);
            session.gl->ClearDepthf(std::min(1.0f, std::max(0.0f, depth)));
            session.gl->Clear(GL_DEPTH_BUFFER_BIT);
            EXPECT_GT(links.draw_within(session.gl, 64, 48, plan, n), 0u);
        }
        session.gl->ClearDepthf(1);
        EXPECT_EQ(session.gl.take_error(), 0u);
        EXPECT_EQ(session.gl.denied().total, 0u);
        return session.pixels()[4 * (24 * 64 + 32)];
    }
};

constexpr DepthPlan kWhole{{{1, 100'000}, {}}, 1};

TEST(QuadDrawer, LinksAreHiddenByWhatIsNearer) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        LinkSession gl(device);
        gl.links.batch().set_distance(3000);
        gl.links.batch().box({0, 0, 64, 48}, {200, 0, 0});
        EXPECT_EQ(gl.middle(5000, kWhole), 200) << device;
        EXPECT_EQ(gl.middle(2900, kWhole), 0) << device;
        EXPECT_EQ(gl.middle(3100, kWhole), 200) << device;
    }
}

TEST(QuadDrawer, ALinkStandsInOneOfTwoRanges) {
    constexpr DepthPlan kFarAndNear{{{980, 400'000}, {2.5, 1000}}, 2};
    for (const double distance_m : {10.0, 900.0, 979.0, 985.0, 999.0, 1001.0, 5000.0}) {
        LinkSession gl(distance_m > 990 ? "es3-mid" : "es2-small");
        gl.links.batch().set_distance(distance_m);
        gl.links.batch().box({0, 0, 64, 48}, {200, 0, 0, 128});
        EXPECT_NEAR(gl.middle(300'000, kFarAndNear), 100, 1) << "mixed once, at " << distance_m;
    }
}

TEST(QuadDrawer, LinesAreHiddenFromWhereTheyAreBehind) {
    LinkSession gl("es3-mid");
    gl.links.batch().set_distance(100, 1000);
    gl.links.batch().line({-1, 24}, {65, 24}, 60, {200, 0, 0});
    // 1 / distance is linear in the picture: in its middle 1 / (0.5 / 100 + 0.5 / 1000) = 182 m.
    EXPECT_EQ(gl.middle(190, kWhole), 200);
    EXPECT_EQ(gl.middle(174, kWhole), 0);
}

/// From 990 m to 1010 m through where two ranges part, and their overlap.
TEST(QuadDrawer, ALineThroughBothRangesIsDrawnOnceEverywhere) {
    constexpr DepthPlan kFarAndNear{{{980, 400'000}, {2.5, 1000}}, 2};
    for (const char* device : {"es2-small", "es3-mid"}) {
        LinkSession gl(device);
        gl.links.batch().set_distance(990, 1010);
        gl.links.batch().line({-1, 24}, {65, 24}, 60, {200, 0, 0, 128});
        static_cast<void>(gl.middle(300'000, kFarAndNear));
        const auto pixels = gl.session.pixels();
        for (std::size_t x = 0; x < 64; ++x) EXPECT_NEAR(pixels[4 * (24 * 64 + x)], 100, 1) << device << ", " << x;
    }
}

TEST(QuadDrawer, SignsBorrowWhatTheSymbologyHas) {
    QuadSession gl("egl", "es2-small", 640, 480, true);
    const TextStyle style{24, {255, 255, 255}};
    for (test_support::FilledQuads* drawer : {&gl.quads, &gl.signs})
        ASSERT_TRUE(drawer->batch().text("Davos", {320, 240}, TextAnchor::center, style));
    const auto expected = gl.picture();
    gl.quads.batch().clear();
    EXPECT_NE(gl.picture(), expected);
    gl.signs.draw(gl.session.gl, 640, 480);
    EXPECT_EQ(gl.session.pixels(), expected);
}

}  // namespace
}  // namespace tedavis::draw::test_quad_drawer
