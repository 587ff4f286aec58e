// The terrain by rays shows what the terrain by triangles shows, and everything else stands on it as it does there.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "platform/threads/thread_workers.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/scene/loaded_scene.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::display::test_traced_pictures {
namespace {

using design::TerrainRenderer;

constexpr std::uint32_t kWidth = 400, kHeight = 300;

/// Land, sea and ground without data.
const test_support::BuiltDatabase& coast() {
    static const test_support::BuiltDatabase built([] {
        host_sim::Raster raster = test_support::make_rough_raster(161, 161);
        for (std::uint32_t j = 0; j < 161; ++j)
            for (std::uint32_t i = 0; i < 161; ++i) {
                const std::size_t at = raster.at(i, j);
                if (i + j < 130) raster.height_m[at] = 0;
                if (i + j < 130) raster.post_class[at] = terrain::PostClass::sea;
                if (i > 110 && j > 100 && j < 130) raster.post_class[at] = terrain::PostClass::void_;
            }
        return raster;
    }());
    return built;
}

const host_sim::AircraftPose kPoses[] = {
    {47.0, 9.64, 2000, 30, -12, 0}, {46.99, 9.7, 1500, 300, -5, 25}, {47.06, 9.62, 3500, 150, -35, 0}};

design::DesignSettings design_by(TerrainRenderer renderer, double tau_px = 0.1) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.terrain.style.texture = design::TerrainTexture::hypsometric;  // a style that is drawn as codes
    design.terrain.style.shade.ambient_occlusion = 0;
    design.terrain.style.grid = {};
    design.terrain.renderer = renderer;
    design.terrain.tau_px = tau_px;
    return design;
}

struct Shown {
    std::vector<std::uint8_t> rgba;
    TerrainRecord terrain;
    bool is_flagged = false;
    std::uint64_t traced_bytes = 0, picture_bytes = 0;
};

struct Stage {
    const char* device = "es3-mid";
    std::uint32_t workers = 1;
    base::ByteSource* scene = nullptr;
};

Shown shown(const design::DesignSettings& design, const host_sim::AircraftPose& pose, const Stage& stage = {}) {
    test_support::MemoryBytes bytes(coast().image);
    const auto workers = platform::make_thread_workers({stage.workers, nullptr});
    EXPECT_TRUE(workers.ok());
    test_support::HeadlessDisplay headless("egl", test_support::shipped_device(stage.device), kWidth, kHeight, &bytes, design,
                                           test_support::as_it_is, stage.scene, nullptr, workers.value().get());
    const flight::AircraftState aircraft = host_sim::posed_aircraft(pose, headless.display());
    Shown result;
    result.rgba = test_support::settled_pixels(headless, aircraft, host_sim::kPosedTime);
    const FrameRecord& record = headless.display().record();
    result.terrain = record.terrain;
    for (const Name& flag : record.flags) result.is_flagged = result.is_flagged || flag.view() == "terrain.not_traced";
    const base::BudgetTable& budget = headless.display().planner().budget();
    if (const auto* line = budget.find(effects::kTracedTerrain)) result.traced_bytes = line->use.in_use;
    if (const auto* line = budget.find(effects::kTracedPictures)) result.picture_bytes = line->use.in_use;
    return result;
}

/// Share of pixels in which a channel differs by more than `steps`.
double share_apart(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, int steps) {
    std::size_t apart = 0;
    for (std::size_t n = 0; n < a.size(); n += 4) {
        bool differs = false;
        for (std::size_t c = n; c < n + 3; ++c) differs = differs || std::abs(int{a[c]} - int{b[c]}) > steps;
        apart += differs ? 1 : 0;
    }
    return static_cast<double>(apart) / (0.25 * static_cast<double>(a.size()));
}

/// A way at a height that some hills reach.
test_support::FlakyBytes way() {
    host_sim::LayerDraft layer;
    layer.name = "way";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    for (int n = 0; n <= 40; ++n) layer.points.push_back(test_support::scene_point(47.0 + 0.001 * n, 9.62 + 0.002 * n, 1150));
    layer.starts = {0, 41};
    return test_support::FlakyBytes(host_sim::sdb_bytes(host_sim::SceneDraft{"way", "a test", 1, {layer}}));
}

design::DesignSettings with_way(design::DesignSettings design) {
    design::DataElement element;
    element.layer = "way";
    element.technique = design::DataTechnique::tube;
    element.size_m = 60;
    EXPECT_TRUE(design.data.elements.try_push_back(element));
    return design;
}

/// Triangles are a tenth of a pixel off at most. Where a coast or a silhouette lies another pixel may have it; along coasts
/// triangles that are larger than bays blur them (the last pose).
TEST(TracedPictures, ShowWhatTrianglesShow) {
    const double most_apart[] = {0.001, 0.001, 0.005};
    for (std::size_t n = 0; n < 3; ++n) {
        const Shown traced = shown(design_by(TerrainRenderer::trace), kPoses[n]),
                    drawn = shown(design_by(TerrainRenderer::raster), kPoses[n]);
        EXPECT_EQ(traced.terrain.renderer.view(), "trace");
        EXPECT_EQ(drawn.terrain.renderer.view(), "raster");
        EXPECT_TRUE(traced.terrain.renderer_reason.empty() && drawn.terrain.renderer_reason.empty());
        EXPECT_FALSE(traced.is_flagged || drawn.is_flagged);
        EXPECT_EQ(traced.terrain.worst_error_px, 0);
        EXPECT_EQ(traced.terrain.triangles, 0u);
        EXPECT_GT(drawn.terrain.triangles, 100u);
        EXPECT_LT(share_apart(traced.rgba, drawn.rgba, 3), most_apart[n]) << n;
    }
}

/// A style that codes cannot tell, and what it is called in failures.
struct Style {
    const char* name;
    void (*change)(design::DesignSettings&);
    double most_apart;  ///< share of pixels that differ by more than 3 steps
};

const Style kStyles[] = {
    {"as shipped", [](design::DesignSettings&) {}, 0.02},
    {"slope, no silhouettes",
     [](design::DesignSettings& d) {
         d.terrain.style.texture = design::TerrainTexture::slope;
         d.terrain.style.sketch.silhouettes = 0;
     },
     0.02},
    {"hatching and form lines",
     [](design::DesignSettings& d) {
         d.terrain.style.sketch.hatching = 1;
         d.terrain.style.sketch.ridges = d.terrain.style.sketch.valleys = 1;
     },
     0.03},
    {"contours", [](design::DesignSettings& d) { d.terrain.style.sketch.contours = 1; }, 0.03},
    {"air", [](design::DesignSettings& d) { d.sky.air.is_shown = true; }, 0.02},
    {"openness and light of the map",
     [](design::DesignSettings& d) {
         d.terrain.style.texture = design::TerrainTexture::openness;
         d.terrain.style.shade.technique = design::TerrainShade::light_map;
     },
     0.02},
};

design::DesignSettings styled(const Style& style, TerrainRenderer renderer, double tau_px = 0.1) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.terrain.renderer = renderer;
    design.terrain.tau_px = tau_px;
    style.change(design);
    return design;
}

/// Places have 16 bits in their chunks, normals 10 and 10; attribute pages are those of the chunks that triangles would be drawn
/// of.
TEST(TracedPictures, StylesThatCodesCannotTellAreThoseOfTriangles) {
    for (const Style& style : kStyles)
        for (const host_sim::AircraftPose& pose : kPoses) {
            const Shown traced = shown(styled(style, TerrainRenderer::trace), pose),
                        drawn = shown(styled(style, TerrainRenderer::raster), pose);
            EXPECT_EQ(traced.terrain.renderer.view(), "trace") << style.name;
            EXPECT_EQ(traced.terrain.triangles, 0u) << style.name;
            EXPECT_EQ(traced.terrain.worst_error_px, 0) << style.name;
            EXPECT_FALSE(traced.is_flagged) << style.name;
            EXPECT_LT(share_apart(traced.rgba, drawn.rgba, 3), style.most_apart) << style.name << " heading " << pose.heading_deg;
        }
    const Shown other = shown(styled(kStyles[1], TerrainRenderer::trace), kPoses[0]),
                shipped = shown(styled(kStyles[0], TerrainRenderer::raster), kPoses[0]);
    EXPECT_GT(share_apart(other.rgba, shipped.rgba, 3), 0.2) << "a control: another style";
}

TEST(TracedPictures, DataStandOnItAndAreHiddenByItAsOnTriangles) {
    test_support::FlakyBytes scene = way();
    const Stage with_scene{"es3-mid", 1, &scene};
    for (const host_sim::AircraftPose& pose : {kPoses[0], host_sim::AircraftPose{47.0, 9.64, 1190, 45, -3, 0}}) {
        const Shown traced = shown(with_way(design_by(TerrainRenderer::trace)), pose, with_scene),
                    drawn = shown(with_way(design_by(TerrainRenderer::raster)), pose, with_scene),
                    bare = shown(design_by(TerrainRenderer::raster), pose, with_scene);
        EXPECT_EQ(traced.terrain.renderer.view(), "trace");
        EXPECT_LT(share_apart(traced.rgba, drawn.rgba, 3), 0.002);
        EXPECT_GT(share_apart(bare.rgba, drawn.rgba, 3), 0.004) << "a control: the way is in view";
        const Shown shaded = shown(with_way(styled(kStyles[0], TerrainRenderer::trace)), pose, with_scene),
                    as_triangles = shown(with_way(styled(kStyles[0], TerrainRenderer::raster)), pose, with_scene);
        EXPECT_EQ(shaded.terrain.renderer.view(), "trace");
        EXPECT_LT(share_apart(shaded.rgba, as_triangles.rgba, 3), kStyles[0].most_apart);
    }
}

TEST(TracedPictures, AnotherTerrainIsSeen) {
    const Shown coarse = shown(design_by(TerrainRenderer::raster, 8), kPoses[0]),
                traced = shown(design_by(TerrainRenderer::trace, 8), kPoses[0]);
    EXPECT_GT(share_apart(coarse.rgba, traced.rgba, 3), 0.005) << "a control: triangles eight pixels off";
    EXPECT_EQ(traced.rgba, shown(design_by(TerrainRenderer::trace), kPoses[0]).rgba) << "rays know no tau";
}

TEST(TracedPictures, AreTheSameForAnyNumberOfWorkers) {
    const Shown one = shown(design_by(TerrainRenderer::trace), kPoses[0]);
    for (const std::uint32_t workers : {2u, 3u, 7u})
        EXPECT_EQ(shown(design_by(TerrainRenderer::trace), kPoses[0], {"es3-mid", workers}).rgba, one.rgba) << workers;
}

/// One display goes from one renderer to the other and back; what it was not started with it refuses.
TEST(TracedPictures, DesignsWithAndWithoutRaysFollowOneAnother) {
    design::DesignSettings rays = design_by(TerrainRenderer::trace), triangles = design_by(TerrainRenderer::raster);
    rays.effects.fade_s = triangles.effects.fade_s = 0;  // no time passes here
    test_support::MemoryBytes bytes(coast().image);
    const auto pixels_of = [](test_support::HeadlessDisplay& headless) {
        return test_support::settled_pixels(headless, host_sim::posed_aircraft(kPoses[0], headless.display()),
                                            host_sim::kPosedTime);
    };
    {
        test_support::HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &bytes, rays);
        const std::vector<std::uint8_t> traced = pixels_of(headless);
        ASSERT_TRUE(headless.display().set_design(triangles));
        const std::vector<std::uint8_t> drawn = pixels_of(headless);
        EXPECT_EQ(headless.display().record().terrain.renderer.view(), "raster");
        EXPECT_NE(traced, drawn);
        ASSERT_TRUE(headless.display().set_design(rays));
        EXPECT_EQ(pixels_of(headless), traced);
        EXPECT_EQ(headless.display().record().terrain.renderer.view(), "trace");
    }
    test_support::HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &bytes, triangles);
    EXPECT_FALSE(headless.display().set_design(rays));
}

/// A device file of before, which has room for codes: they are traced, and other styles are drawn by triangles as ever.
TEST(TracedPictures, WithoutRoomForAGeometryPictureCodesAreStillTraced) {
    const auto show = [](const design::DesignSettings& design) {
        effects::DeviceSettings device = test_support::shipped_device("es3-mid");
        device.budget.find(effects::kTracedPictures)->bytes = 4u * 1024 * 768;
        test_support::MemoryBytes bytes(coast().image);
        test_support::HeadlessDisplay headless("egl", device, kWidth, kHeight, &bytes, design);
        Shown result;
        result.rgba =
            test_support::settled_pixels(headless, host_sim::posed_aircraft(kPoses[0], headless.display()), host_sim::kPosedTime);
        result.terrain = headless.display().record().terrain;
        return result;
    };
    EXPECT_EQ(show(design_by(TerrainRenderer::trace)).terrain.renderer.view(), "trace");
    const Shown drawn = show(styled(kStyles[1], TerrainRenderer::trace));
    EXPECT_EQ(drawn.terrain.renderer.view(), "raster");
    EXPECT_EQ(drawn.terrain.renderer_reason.view(), "the device has no room for it");
    EXPECT_EQ(drawn.rgba, show(styled(kStyles[1], TerrainRenderer::raster)).rgba);
}

TEST(TracedPictures, WhoDoesNotAskPaysNothing) {
    const Shown drawn = shown(design_by(TerrainRenderer::raster), kPoses[0]),
                traced = shown(design_by(TerrainRenderer::trace), kPoses[0]);
    EXPECT_EQ(drawn.traced_bytes, 0u);
    EXPECT_EQ(drawn.picture_bytes, 0u);
    EXPECT_GT(traced.traced_bytes, 161u * 161 * 8);
    EXPECT_EQ(traced.picture_bytes, kWidth * kHeight * 4u);
    EXPECT_EQ(shown(styled(kStyles[0], TerrainRenderer::trace), kPoses[0]).picture_bytes, kWidth * kHeight * 20u);
}

effects::CostTable costs_of(double terrain_ms_per_thousand, double rays_ms_per_megapixel) {
    effects::CostTable table;
    table.is_known = true;
    table[effects::Effect::terrain] = {0, 0, terrain_ms_per_thousand};
    table[effects::Overhead::rays] = {0, rays_ms_per_megapixel, 0};
    return table;
}

/// Either choice draws the very picture of the design that asks for this renderer.
TEST(TracedPictures, ADesignThatLeavesTheChoiceIsDrawnByTheCheaperRenderer) {
    test_support::MemoryBytes bytes(coast().image);
    std::vector<std::uint8_t> unknown, traced;
    {
        test_support::HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &bytes, design_by(TerrainRenderer::automatic));
        PlannerMemory& memory = headless.display().memory();
        const flight::AircraftState aircraft = host_sim::posed_aircraft(kPoses[0], headless.display());
        const auto picture_by = [&](const effects::CostTable& costs) {
            memory.budget.hold(0, costs);
            return test_support::settled_pixels(headless, aircraft, host_sim::kPosedTime);
        };
        const FrameRecord& record = headless.display().record();
        unknown = picture_by({});
        EXPECT_EQ(record.terrain.renderer.view(), "raster");
        EXPECT_EQ(record.terrain.renderer_reason.view(), "no calibration states what rays cost");
        traced = picture_by(costs_of(1000, 0.001));
        EXPECT_EQ(record.terrain.renderer.view(), "trace");
        EXPECT_EQ(record.terrain.worst_error_px, 0);
        EXPECT_GT(record.terrain.triangles_ms, record.terrain.rays_ms);
        EXPECT_EQ(record.governor.predicted_ms, record.terrain.rays_ms);
        EXPECT_EQ(picture_by(costs_of(0.001, 1000)), unknown);
        EXPECT_EQ(record.terrain.renderer.view(), "raster");
        EXPECT_GT(record.terrain.worst_error_px, 0);
    }
    EXPECT_NE(traced, unknown);
    EXPECT_EQ(traced, shown(design_by(TerrainRenderer::trace), kPoses[0]).rgba);
    EXPECT_EQ(unknown, shown(design_by(TerrainRenderer::raster), kPoses[0]).rgba);
}

/// A shaded style too; its triangles are drawn off screen, as those that stand in for rays are.
TEST(TracedPictures, AShadedDesignThatLeavesTheChoiceIsTracedAsWhereRaysAreAskedFor) {
    test_support::MemoryBytes bytes(coast().image);
    std::vector<std::uint8_t> traced;
    {
        test_support::HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &bytes,
                                               styled(kStyles[0], TerrainRenderer::automatic));
        headless.display().memory().budget.hold(0, costs_of(1000, 0.001));
        traced =
            test_support::settled_pixels(headless, host_sim::posed_aircraft(kPoses[0], headless.display()), host_sim::kPosedTime);
        EXPECT_EQ(headless.display().record().terrain.renderer.view(), "trace");
        headless.display().memory().budget.hold(0, costs_of(0.001, 1000));
        const auto drawn =
            test_support::settled_pixels(headless, host_sim::posed_aircraft(kPoses[0], headless.display()), host_sim::kPosedTime);
        EXPECT_EQ(headless.display().record().terrain.renderer.view(), "raster");
        EXPECT_LT(share_apart(drawn, traced, 3), kStyles[0].most_apart);
        EXPECT_NE(drawn, traced);
    }
    EXPECT_EQ(traced, shown(styled(kStyles[0], TerrainRenderer::trace), kPoses[0]).rgba);
}

/// Where rays cannot be, the picture is that of triangles, and the record says why.
TEST(TracedPictures, WhatCannotBeTracedIsDrawnAndSaidToBe) {
    struct Row {
        const char* device;
        double shadows_in_air;
        const char* reason;
    };
    const Row rows[] = {{"es2-small", 0, "the device's lane is es2"},
                        {"es3-mid", 0.5, "light shafts alone, blur round a focus or magnified foci"}};
    for (const Row& row : rows) {
        design::DesignSettings asked = design_by(TerrainRenderer::trace), plain = design_by(TerrainRenderer::raster);
        if (row.shadows_in_air > 0) asked.terrain.style.sketch.silhouettes = plain.terrain.style.sketch.silhouettes = 0;
        asked.effects.shadows.in_air = plain.effects.shadows.in_air = row.shadows_in_air;
        const Shown drawn = shown(asked, kPoses[0], {row.device});
        EXPECT_EQ(drawn.terrain.renderer.view(), "raster") << row.device;
        EXPECT_EQ(drawn.terrain.renderer_reason.view(), row.reason);
        EXPECT_TRUE(drawn.is_flagged);
        EXPECT_EQ(drawn.traced_bytes, 0u);
        EXPECT_EQ(drawn.rgba, shown(plain, kPoses[0], {row.device}).rgba) << row.device;
    }
}

}  // namespace
}  // namespace tedavis::display::test_traced_pictures
