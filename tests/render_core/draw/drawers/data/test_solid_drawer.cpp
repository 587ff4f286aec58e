#include "render_core/draw/drawers/data/solid_drawer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_solid_drawer {
namespace {

using test_support::GlSession;

constexpr DepthRange kRange{1, 10'000};
constexpr design::Color kRed{200, 0, 0}, kBlue{0, 0, 200};
constexpr std::int64_t kHour_ns = 3'600'000'000'000;

/// Squares that face the eye, each over the whole of the picture or a part in the middle of it.
struct SolidSession {
    explicit SolidSession(const std::string& device = "es2-small") : session("egl", device), block(1u << 22) {
        base::Arena arena(block.data(), block.size());
        base::BudgetLine& line = *session.device.budget.find(effects::kSceneSolidVertices);
        EXPECT_TRUE(solids.start(session.gl, line, arena, {1024, 3072, 16}, gl::BufferUse::streamed).message.empty());
        EXPECT_TRUE(drawer.start(session.gl, arena, 16).message.empty());
        EXPECT_TRUE(mesh.start(arena));
        session.gl.seal();
        const glm::dvec3 eye = earth::to_ecef({0.8, 0.2, {2000}});
        frame.view = test_support::free_view(eye, earth::body_axes(0.8, 0.2, 0.3, 0, 0), 64, 48, 1);
        frame.towards_light = -frame.view.forward;
    }
    ~SolidSession() {
        session.gl.retire();
        drawer.destroy(session.gl);
        solids.destroy(session.gl);
    }
    void add_square(double distance_m, double half_m, design::Color color, double level = 0, bool shaded = true,
                    bool turned = false) {
        const glm::dvec3 middle = frame.view.eye + frame.view.forward * distance_m;
        const glm::dvec3 right = frame.view.right * half_m, up = -frame.view.down * half_m;
        mesh.begin(middle);
        mesh.set_color(color, scene::Uncertainty::from_level(level));
        const glm::dvec3 normal = shaded ? -frame.view.forward : glm::dvec3(0);
        const std::uint16_t a = mesh.vertex(middle - right - up, normal), b = mesh.vertex(middle + right - up, normal);
        const std::uint16_t c = mesh.vertex(middle + right + up, normal), d = mesh.vertex(middle - right + up, normal);
        mesh.triangle(a, turned ? c : b, turned ? b : c);
        mesh.triangle(a, turned ? d : c, turned ? c : d);
        EXPECT_TRUE(mesh.add_to(solids.batch()));
    }
    /// The pixel in the middle over black; `wall_m`: terrain stands there already.
    design::Color middle(double wall_m = 0) { return pixel(32, 24, wall_m); }
    design::Color pixel(std::size_t x, std::size_t y, double wall_m = 0) {
        gl::bind_surface(session.gl, *session.surface);
        session.gl->ClearColor(0, 0, 0, 1);
        if (wall_m > 0) session.gl->ClearDepthf(window_depth(wall_m));
        session.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        session.gl->ClearDepthf(1);
        session.gl->Enable(GL_DEPTH_TEST);
        EXPECT_TRUE(solids.upload(session.gl));
        const SolidBuffers* const all[] = {&solids};
        drawer.draw(session.gl, all, {frame, shown, time_ns, has_date}, kRange);
        EXPECT_EQ(session.gl.take_error(), 0u);
        EXPECT_EQ(session.gl.denied().total, 0u);
        const auto pixels = session.pixels();
        const std::uint8_t* at = &pixels[4 * (y * 64 + x)];
        return {at[0], at[1], at[2]};
    }
    static float window_depth(double distance_m) {
        const double n = kRange.near_m, f = kRange.far_m;
        return static_cast<float>(0.5 + 0.5 * ((f + n) - 2 * f * n / distance_m) / (f - n));
    }

    GlSession session;
    std::vector<unsigned char> block;
    test_support::FilledSolids solids;
    SolidDrawer drawer;
    SolidMesh mesh;
    DataFrame frame;
    std::uint32_t shown = ~0u;
    std::int64_t time_ns = 0;
    bool has_date = false;
};

SolidLook mixed(float opacity) {
    SolidLook look;
    look.opacity = opacity;
    look.is_mixed = true;
    return look;
}

TEST(SolidDrawer, ColorsAreWhatTheyAreInBothLanes) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        SolidSession test(device);
        test.add_square(100, 500, {12, 200, 99});
        EXPECT_EQ(test.middle(), (design::Color{12, 200, 99})) << device << ", facing the light";
        test.solids.batch().clear();
        test.add_square(100, 500, {12, 200, 99}, 0, false);
        test.frame.towards_light = test.frame.view.forward;
        EXPECT_EQ(test.middle(), (design::Color{12, 200, 99})) << device << ", not shaded";
        test.solids.batch().clear();
        test.add_square(100, 500, {200, 200, 200});
        test.frame.ambient = 0.5;
        EXPECT_NEAR(test.middle().green, 100, 1) << device << ", turned away";
    }
}

TEST(SolidDrawer, HazeHidesWhatIsFar) {
    SolidSession test;
    test.frame.haze = {100, 110, 120};
    test.frame.haze_per_m = 1 / 1000.0;
    test.add_square(1000, 5000, kRed);
    const double share = std::exp(-1.0);
    EXPECT_NEAR(test.middle().red, 200 * share + 100 * (1 - share), 2);
}

TEST(SolidDrawer, TerrainHidesThemOrLeavesAGhost) {
    SolidSession test;
    test.add_square(1000, 5000, kRed);
    EXPECT_EQ(test.middle(500), (design::Color{0, 0, 0}));
    EXPECT_EQ(test.middle(2000), kRed);
    test.solids.batch().clear();
    SolidLook look;
    look.ghost = 0.25f;
    test.solids.batch().set_look(look, 0);
    test.add_square(1000, 5000, kRed);
    EXPECT_NEAR(test.middle(500).red, 50, 1);
    EXPECT_EQ(test.middle(2000), kRed) << "nothing but terrain makes ghosts";
}

TEST(SolidDrawer, MixedOnesAreMixedFromTheFarthest) {
    for (const bool nearer_first : {false, true}) {
        SolidSession test;
        test.solids.batch().set_look(mixed(0.5f), 0);
        test.add_square(nearer_first ? 100 : 200, 5000, nearer_first ? kRed : kBlue);
        test.add_square(nearer_first ? 200 : 100, 5000, nearer_first ? kBlue : kRed);
        const design::Color color = test.middle();
        EXPECT_NEAR(color.red, 100, 1);
        EXPECT_NEAR(color.blue, 50, 1);
    }
}

TEST(SolidDrawer, WhatIsMixedHidesNothing) {
    SolidSession test;
    test.solids.batch().set_look(mixed(0.5f), 0);
    test.add_square(100, 5000, kRed);
    test.solids.batch().set_look({}, 0);
    test.add_square(200, 5000, kBlue);
    const design::Color color = test.middle();
    EXPECT_NEAR(color.red, 100, 1);
    EXPECT_NEAR(color.blue, 100, 1);
}

TEST(SolidDrawer, TheHollowAreNotSeenFromInside) {
    for (const bool is_hollow : {false, true}) {
        SolidSession test;
        SolidLook look = mixed(0.5f);
        look.is_hollow = is_hollow;
        test.solids.batch().set_look(look, 0);
        test.add_square(100, 500, kRed, 0, true, true);
        EXPECT_NEAR(test.middle().red, is_hollow ? 0 : 100, 1) << "turned away";
        test.solids.batch().clear();
        test.add_square(100, 500, kRed);
        EXPECT_NEAR(test.middle().red, 100, 1);
    }
}

TEST(SolidDrawer, WhatIsNearFadesToNothing) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        SolidSession test(device);
        const auto red_at = [&](double distance_m, float near_m, bool is_mixed) {
            test.solids.batch().clear();
            SolidLook look = is_mixed ? mixed(0.5f) : SolidLook();
            look.near_m = near_m;
            look.is_hollow = true;
            test.solids.batch().set_look(look, 0);
            test.add_square(distance_m, 5000, kRed);
            return int{test.middle().red};
        };
        EXPECT_EQ(red_at(59, 60, true), 0) << device;
        EXPECT_NEAR(red_at(150, 60, true), 50, 2) << device;
        EXPECT_NEAR(red_at(241, 60, true), 100, 2) << device;
        EXPECT_NEAR(red_at(59, 0, true), 100, 2) << "others do not";
        EXPECT_EQ(red_at(119, 60, false), 0) << device << ", opaque";
        EXPECT_EQ(red_at(121, 60, false), 200) << device << ", opaque, all at once";
        EXPECT_EQ(red_at(59, 0, false), 200);
    }
}

TEST(SolidDrawer, WhatHasFadedHidesNothing) {
    SolidSession test;
    SolidLook look;
    look.near_m = 60;
    for (const bool is_near : {false, true}) {
        test.solids.batch().clear();
        test.solids.batch().set_look(look, 0);
        test.add_square(is_near ? 50 : 150, 5000, kRed);
        test.solids.batch().set_look({}, 0);
        test.add_square(200, 5000, kBlue);
        EXPECT_EQ(test.middle(), is_near ? kBlue : kRed);
    }
}

TEST(SolidDrawer, TheUnsureFadesAndGrows) {
    SolidSession test;
    SolidLook look;
    look.fading = SolidFading::transparency;
    look.fading_strength = 1;
    look.growth_per_hour = 0.25f;
    test.solids.batch().set_look(look, 0);
    test.add_square(100, 5000, kRed, 0.5);
    EXPECT_NEAR(test.middle().red, 100, 2);
    test.has_date = true;
    test.time_ns = kHour_ns;
    EXPECT_NEAR(test.middle().red, 50, 2) << "an hour old";
    test.time_ns = -kHour_ns;
    EXPECT_NEAR(test.middle().red, 50, 2) << "an hour ahead";
    test.time_ns = 9 * kHour_ns;
    EXPECT_EQ(test.middle().red, 0);
}

TEST(SolidDrawer, TheUnknownIsCutByStripes) {
    for (const char* device : {"es2-small", "es3-mid"})
        for (const SolidFading fading : {SolidFading::none, SolidFading::saturation, SolidFading::transparency}) {
            SolidSession test(device);
            SolidLook look;
            look.fading = fading;
            look.fading_strength = 1;
            look.is_mixed = fading == SolidFading::transparency;
            test.solids.batch().set_look(look, 0);
            test.add_square(100, 5000, kRed, std::nan(""));
            int whole = 0, none = 0;
            for (int x = 14; x < 50; ++x) {
                const design::Color color = test.pixel(x, 32);
                whole += color == kRed ? 1 : 0;
                none += color == design::Color{0, 0, 0} ? 1 : 0;
            }
            EXPECT_EQ(whole, fading == SolidFading::none ? 36 : 24) << device << ": its own colour, for it is no grade of unsure";
            EXPECT_EQ(none, fading == SolidFading::none ? 0 : 12) << device;
        }
}

TEST(SolidDrawer, GroupsAreHiddenTogether) {
    SolidSession test;
    SolidLook look;
    look.group = 5;
    test.solids.batch().set_look(look, 0);
    test.add_square(100, 5000, kRed);
    test.shown = 1u << 5;
    EXPECT_EQ(test.middle(), kRed);
    test.shown = ~(1u << 5);
    EXPECT_EQ(test.middle(), (design::Color{0, 0, 0}));
}

TEST(SolidDrawer, ARimIsAsWideNearAndFar) {
    for (const double distance_m : {100.0, 4000.0}) {
        SolidSession test;
        SolidLook rim;
        rim.halo_px = 4;
        test.solids.batch().set_look(rim, 0);
        const glm::dvec3 middle = test.frame.view.eye + test.frame.view.forward * distance_m;
        // A square seen from behind, whose corners swell to the right and up.
        const double half = 8 * distance_m / test.frame.view.focal_px;
        const glm::dvec3 right = test.frame.view.right, up = -test.frame.view.down;
        test.mesh.begin(middle);
        test.mesh.set_color(kBlue);
        const std::uint16_t a = test.mesh.vertex(middle - right * half - up * half, -right);
        const std::uint16_t b = test.mesh.vertex(middle + right * half - up * half, right);
        const std::uint16_t c = test.mesh.vertex(middle + right * half + up * half, right);
        const std::uint16_t d = test.mesh.vertex(middle - right * half + up * half, -right);
        test.mesh.triangle(a, c, b);
        test.mesh.triangle(a, d, c);
        ASSERT_TRUE(test.mesh.add_to(test.solids.batch()));
        EXPECT_EQ(test.pixel(32 + 8 + 2, 24), kBlue) << distance_m;
        EXPECT_EQ(test.pixel(32 + 8 + 6, 24), (design::Color{0, 0, 0})) << distance_m;
    }
}

TEST(SolidDrawer, WhatLiesOnTheGroundIsRaisedAboveItsErrors) {
    for (const float raised_px : {0.0f, 2.0f}) {
        SolidSession test;
        SolidLook look;
        look.raised_px = raised_px;
        test.solids.batch().set_look(look, 0);
        test.add_square(1000, 500, kRed);
        const double reach_m = 1000 * 2 / test.frame.view.focal_px;
        EXPECT_EQ(test.middle(1000 - 0.7 * reach_m), raised_px > 0 ? kRed : (design::Color{0, 0, 0}));
        EXPECT_EQ(test.middle(1000 - 1.3 * reach_m), (design::Color{0, 0, 0})) << "a ridge before it hides it";
    }
}

}  // namespace
}  // namespace tedavis::draw::test_solid_drawer
