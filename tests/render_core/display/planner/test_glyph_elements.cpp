#include "render_core/display/planner/glyph_elements.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "render_core/draw/drawers/data/glyph_drawer.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::display::test_glyph_elements {
namespace {

using design::DataTechnique;

constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000 / 60'000'000'000 * 60'000'000'000;
constexpr std::int64_t kMinute_ns = 60'000'000'000, kHour_ns = 60 * kMinute_ns;

/// Temperatures over 46.5 N 9.4 E that change by 24 K within an hour.
host_sim::LayerDraft changing_air() {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.times_ns = {kStart_ns, kStart_ns + kHour_ns};
    return layer;
}

/// Glyphs of one layer on a device, seen from the south.
struct GlyphView {
    explicit GlyphView(const char* device = "es3-mid") : session("egl", device), scene(changing_air()) {
        block.resize(session.device.budget.find(effects::kSceneGlyphs)->bytes);
        base::Arena arena(block.data(), block.size());
        const bool has_instances = draw::GlyphDrawer::has_instances(session.gl);
        EXPECT_EQ(glyphs.start(has_instances, session.device.budget, arena).message.view(), "");
        base::BudgetLine& line = *session.device.budget.find(effects::kSceneGlyphVertices);
        EXPECT_EQ(drawer.start(session.gl, line, arena).message.view(), "");
        session.gl.seal();
        element.technique = DataTechnique::spheres;
        element.by_color.attribute = "temperature";
        EXPECT_TRUE(element.by_color.scale.palette.stops.try_push_back({260, {0, 0, 255}}));
        EXPECT_TRUE(element.by_color.scale.palette.stops.try_push_back({310, {255, 0, 0}}));
        EXPECT_TRUE(element.heights_m.try_push_back(1000));
        element.size_m = 16'000;  // posts are 19 km apart
        const glm::dvec3 eye = earth::to_ecef({base::radians(45.6), base::radians(9.4), {12'000}});
        frame.view =
            test_support::free_view(eye, earth::body_axes(base::radians(45.6), base::radians(9.4), 0, -0.1, 0), 160, 120, 10);
    }
    ~GlyphView() {
        session.gl.retire();
        drawer.destroy(session.gl);
    }
    bool add() { return glyphs.add(element, scene.layer()); }
    draw::ElementCount plan(std::int64_t time_ns, bool has_date = true) {
        glyphs.begin_plan();
        return glyphs.plan(0, {ground, frame.view, {255, 0, 255}, time_ns, has_date});
    }
    std::vector<std::uint8_t> picture() {
        gl::bind_surface(session.gl, *session.surface);
        session.gl->ClearColor(0, 0, 0, 1);
        session.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        session.gl->Enable(GL_DEPTH_TEST);
        drawer.upload(session.gl, glyphs.batch());
        if (!glyphs.batch().instances().empty()) static_cast<void>(drawer.draw(session.gl, frame, {10, 400'000}));
        EXPECT_EQ(session.gl.denied().total, 0u);
        return session.pixels();
    }
    std::vector<std::uint8_t> picture_at(std::int64_t time_ns) {
        static_cast<void>(plan(time_ns));
        return picture();
    }

    test_support::GlSession session;
    test_support::LoadedScene scene;
    test_support::LevelGround ground;
    std::vector<unsigned char> block;
    design::DataElement element;
    GlyphElements glyphs;
    draw::GlyphDrawer drawer;
    draw::DataFrame frame;
};

TEST(GlyphElements, AllSitesAreCountedInBothLanes) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        GlyphView view(device);
        ASSERT_TRUE(view.add());
        const draw::ElementCount count = view.plan(kStart_ns);
        EXPECT_EQ(count.all(), 12u) << device;
        EXPECT_GT(count.drawn, 3u) << device;
    }
}

/// Which are as large as the spheres that stand for themselves.
TEST(GlyphElements, BarsOfLittleDetailAreMeansOfSeveral) {
    const auto count = [](DataTechnique technique, double detail) {
        GlyphView view;
        view.element.technique = technique;
        view.element.detail = detail;
        EXPECT_TRUE(view.add());
        return view.plan(kStart_ns);
    };
    const draw::ElementCount spheres = count(DataTechnique::spheres, 0.2), bars = count(DataTechnique::bars, 0.2);
    EXPECT_GT(bars.aggregated, spheres.aggregated);
    EXPECT_EQ(bars.all(), 12u);
    EXPECT_EQ(count(DataTechnique::bars, 1).aggregated, 0u) << "all detail: each itself";
}

TEST(GlyphElements, LessDetailIsFewerGlyphsOfTheSameSites) {
    GlyphView view;
    ASSERT_TRUE(view.add());
    const auto glyphs_at = [&](double detail_factor) {
        view.glyphs.begin_plan();
        GlyphFrameInput frame{view.ground, view.frame.view, {255, 0, 255}, kStart_ns, true};
        frame.detail_factor = detail_factor;
        EXPECT_EQ(view.glyphs.plan(0, frame).all(), 12u);
        return view.glyphs.glyphs();
    };
    const std::uint32_t all = glyphs_at(1);
    EXPECT_GT(all, 3u);
    EXPECT_LT(glyphs_at(0.1), all);
    EXPECT_EQ(glyphs_at(1), all) << "and back";
}

TEST(GlyphElements, ThePictureOfAnInstantDoesNotDependOnWhereTheRunBegan) {
    const std::int64_t then = kStart_ns + 305 * 1'000'000'000LL;
    std::vector<std::uint8_t> expected;
    {
        GlyphView jumped;
        ASSERT_TRUE(jumped.add());
        expected = jumped.picture_at(then);
        EXPECT_NE(jumped.picture_at(then + 30 * kMinute_ns), expected) << "it does change";
        EXPECT_EQ(jumped.picture_at(then), expected) << "and comes back";
    }
    {
        GlyphView flown;
        ASSERT_TRUE(flown.add());
        for (int second = 0; second < 300; second += 7) static_cast<void>(flown.plan(kStart_ns + second * 1'000'000'000LL));
        EXPECT_EQ(flown.picture_at(then), expected);
    }
    GlyphView backwards;
    ASSERT_TRUE(backwards.add());
    static_cast<void>(backwards.plan(kStart_ns + kHour_ns));
    EXPECT_EQ(backwards.picture_at(then), expected);
}

TEST(GlyphElements, WithoutADateTheyStandAtTheirOwnTime) {
    GlyphView view;
    ASSERT_TRUE(view.add());
    static_cast<void>(view.plan(5, false));
    EXPECT_EQ(view.picture(), view.picture_at(kStart_ns));
}

TEST(GlyphElements, UncertaintyHasGlyphsOfItsOwn) {
    const auto picture = [](design::ElementUncertainty uncertainty, DataTechnique technique) {
        GlyphView view;
        view.element.uncertainty = uncertainty;
        view.element.technique = technique;
        EXPECT_TRUE(view.add());
        return view.picture_at(kStart_ns);
    };
    const auto none = picture(design::ElementUncertainty::none, DataTechnique::spheres);
    const auto both = picture(design::ElementUncertainty::tetrahedra, DataTechnique::spheres);
    const auto only = picture(design::ElementUncertainty::tetrahedra, DataTechnique::uncertainty_only);
    EXPECT_NE(none, both);
    EXPECT_NE(only, both);
    EXPECT_NE(only, none);
}

/// Of 250 x 200 posts, at two heights.
host_sim::LayerDraft large_grid(bool changes) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.grid.columns = 250;
    layer.grid.rows = 200;
    layer.grid.step_lon_rad *= 0.01;
    layer.grid.step_lat_rad *= 0.01;
    layer.times_ns = {kStart_ns};
    if (changes) layer.times_ns.push_back(kStart_ns + kHour_ns);
    const std::size_t times = changes ? 2 : 1;
    layer.grid.times = static_cast<std::uint32_t>(times);
    for (host_sim::AttributeDraft& attribute : layer.attributes) {
        attribute.values.assign(times * layer.grid.levels * 250 * 200, 290.0f);
        attribute.uncertainties.clear();
        attribute.states.clear();
    }
    return layer;
}

TEST(GlyphElements, AHundredThousandKeepTheirPlacesWhereThereIsRoom) {
    for (const bool changes : {false, true})
        for (const char* device : {"es3-mid", "desktop", "es2-small"}) {
            GlyphView view(device);
            const test_support::LoadedScene large(large_grid(changes));
            ASSERT_TRUE(view.element.heights_m.try_push_back(2000));
            ASSERT_TRUE(view.add());
            ASSERT_TRUE(view.glyphs.add(view.element, large.layer()));
            view.glyphs.begin_plan();
            const GlyphFrameInput frame{view.ground, view.frame.view, {255, 0, 255}, kStart_ns, true};
            EXPECT_EQ(view.glyphs.plan(0, frame).all(), 24u);
            const draw::ElementCount count = view.glyphs.plan(1, frame);
            EXPECT_EQ(count.all(), 100'000u) << device;
            EXPECT_EQ(view.glyphs.sites_of(1) == 100'000, std::string(device) != "es2-small") << device;
            EXPECT_EQ(view.glyphs.sites_of(0), 24u) << "who needs little has it";
            view.glyphs.clear();
            ASSERT_TRUE(view.add());
            EXPECT_EQ(view.plan(kStart_ns).all(), 24u) << "shared out anew";
        }
}

TEST(GlyphElements, LinksTakeOfTheSameRoomAndAreSeenInBothLanes) {
    const test_support::LoadedScene large(large_grid(false));
    for (const char* device : {"es3-mid", "es2-small"}) {
        const auto plan = [&](bool link, std::vector<std::uint8_t>* pixels) {
            GlyphView view(device);
            view.element.link = link;
            view.element.size_m = 4000;
            EXPECT_TRUE(view.glyphs.add(view.element, large.layer()));
            const draw::ElementCount count = view.plan(kStart_ns);
            *pixels = view.picture();
            return count;
        };
        std::vector<std::uint8_t> linked, free;
        const draw::ElementCount with = plan(true, &linked), without = plan(false, &free);
        EXPECT_EQ(with.all(), without.all()) << device;
        EXPECT_LE(with.drawn, without.drawn) << device;
        EXPECT_NE(linked, free) << device;
    }
}

TEST(GlyphElements, LayersWithoutSitesAreRefused) {
    GlyphView view;
    const test_support::LoadedScene areas(test_support::small_areas());
    EXPECT_FALSE(view.glyphs.add(view.element, areas.layer()));
    view.element.by_color.attribute = "smoke";
    EXPECT_FALSE(view.add());
}

TEST(GlyphElements, TechniquesAreEitherGlyphsOrNot) {
    EXPECT_TRUE(is_glyph_technique(DataTechnique::arrows));
    EXPECT_TRUE(is_glyph_technique(DataTechnique::uncertainty_only));
    EXPECT_FALSE(is_glyph_technique(DataTechnique::prism));
    EXPECT_TRUE(is_glyph_uncertainty(design::ElementUncertainty::circles));
    EXPECT_FALSE(is_glyph_uncertainty(design::ElementUncertainty::transparency));
}

TEST(GlyphElements, ALineThatIsTooSmallIsNamed) {
    test_support::GlSession session("egl", "es3-mid");
    std::vector<unsigned char> block(1000);
    base::Arena arena(block.data(), block.size());
    GlyphElements glyphs;
    EXPECT_NE(glyphs.start(true, session.device.budget, arena).message.view().find("scene_glyphs"), std::string_view::npos);
    session.gl.seal();
    session.gl.retire();
}

}  // namespace
}  // namespace tedavis::display::test_glyph_elements
