#include "render_core/raytrace/picture/traced_scene.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/raytrace/picture/trace_presets.hpp"
#include "tests/support/raytrace/drawn_trace.hpp"

namespace tedavis::raytrace {
namespace {

class TracedSceneTest : public ::testing::Test {
protected:
    using Scene = TracedScene<std::int16_t>;

    TracedSceneTest() : posts_(test_support::fractal_heights(65)) {
        size_.width = 100;
        size_.height = 60;
    }
    Scene::Answer start(Scene& scene, const std::vector<TraceSettings>& settings, std::int64_t spare = 0) {
        const std::int64_t bytes = static_cast<std::int64_t>(Scene::bytes_needed(posts_.grid(), settings)) + spare;
        memory_.resize(static_cast<std::size_t>(bytes));
        base::Arena arena(memory_.data(), memory_.size());
        return scene.start(posts_.grid(), {30, 30, 1}, settings, size_, arena);
    }
    test_support::HeightField<std::int16_t> posts_;
    SceneSize size_;
    std::vector<unsigned char> memory_;
};

std::vector<TraceSettings> stored_and_smooth() {
    TraceSettings stored = quality_preset();
    stored.surface.kind = SurfaceKind::approximate_bicubic;
    stored.is_surface_stored = true;
    TraceSettings averaged = time_preset();
    averaged.antialiasing = Antialiasing::average_mipmap;
    return {quality_preset(), stored, averaged, memory_preset()};
}

TEST_F(TracedSceneTest, NamesWhatItTakesAndTakesNoMore) {
    Scene scene;
    const Scene::Answer all = start(scene, stored_and_smooth());
    ASSERT_TRUE(all.ok());
    EXPECT_LE(scene.bytes(), all.value());
    EXPECT_GE(scene.bytes() + 256, all.value());
    EXPECT_LE(all.value(), memory_.size());
    EXPECT_EQ(scene.items().size(), 6U);
    Scene least;
    ASSERT_TRUE(start(least, {memory_preset()}).ok());
    EXPECT_EQ(least.items().size(), 1U);
    EXPECT_EQ(least.maps().sky, nullptr);
    EXPECT_EQ(least.maps().averages, nullptr);
    // Maxima: a third more than two bytes a cell.
    EXPECT_LT(least.bytes(), 64 * 64 * 2 * 4 / 3 + 200);
}

TEST_F(TracedSceneTest, GivesEachSettingItsTerrain) {
    Scene scene;
    const std::vector<TraceSettings> all = stored_and_smooth();
    ASSERT_TRUE(start(scene, all).ok());
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) EXPECT_NE(&scene.terrain(all[a]), &scene.terrain(all[b]));
}

TEST_F(TracedSceneTest, ASearchHasATerrainOfItsOwnAndConesTakeMemory) {
    TraceSettings exact = time_preset(), cones = time_preset();
    exact.surface.kind = cones.surface.kind = SurfaceKind::bilinear;
    cones.search = usual_search(SearchKind::cones);
    Scene scene;
    const Scene::Answer all = start(scene, {exact, cones});
    ASSERT_TRUE(all.ok());
    EXPECT_NE(&scene.terrain(exact), &scene.terrain(cones));
    EXPECT_LE(all.value(), memory_.size());
    ASSERT_EQ(scene.items().size(), 3U);
    EXPECT_STREQ(scene.items()[2].name.c_str(), "cones");
    EXPECT_GE(scene.items()[2].bytes, 65U * 65 * 4);
    cones.search = usual_search(SearchKind::ray);
    ASSERT_TRUE(start(scene, {exact, cones}).ok());
    EXPECT_EQ(scene.items().size(), 2U) << "control: steps need no cones";
}

/// It has no surface.
class NoTerrain final : public TracedTerrain {
public:
    void trace(const PixelRect&, const HitPicture&) const override {}
    void find_surface(const PixelSpan&, const HitPicture&, SpanSurface&) const override {}
    [[nodiscard]] RayHit intersect(const Ray&) const override { return {}; }
    [[nodiscard]] bool is_hidden(const Ray&) const override { return false; }
};

TEST_F(TracedSceneTest, StandsOverAnotherTerrainForPrimaryHitsOnly) {
    const NoTerrain other;
    Scene scene;
    ASSERT_TRUE(start(scene, stored_and_smooth()).ok());
    ASSERT_TRUE(scene.start(other, {30, 30, 1}, time_preset(), size_).ok());
    EXPECT_EQ(&scene.terrain(time_preset()), &other);
    EXPECT_EQ(scene.bytes(), 0U);
    EXPECT_EQ(scene.maps().sky, nullptr) << "of the start before";
    EXPECT_NE(std::string(scene.start(other, {30, 30, 1}, memory_preset(), size_).error().c_str()).find("secondary rays"),
              std::string::npos);
    size_.height = 0;
    EXPECT_FALSE(scene.start(other, {30, 30, 1}, time_preset(), size_).ok());
    size_.height = 60;
    ASSERT_TRUE(start(scene, {time_preset()}).ok());
    EXPECT_NE(&scene.terrain(time_preset()), &other);
}

TEST_F(TracedSceneTest, SaysWhatItRefuses) {
    Scene scene;
    EXPECT_NE(std::string(start(scene, {}).error().c_str()).find("at least one setting"), std::string::npos);
    EXPECT_NE(std::string(start(scene, stored_and_smooth(), -8000).error().c_str()).find("bytes_needed()"), std::string::npos);
    TraceSettings other = quality_preset();
    other.surface.kind = SurfaceKind::approximate_bicubic;
    EXPECT_NE(std::string(start(scene, {quality_preset(), other}).error().c_str()).find("two different"), std::string::npos);
    TraceSettings by_steps = quality_preset();
    by_steps.search = usual_search(SearchKind::ray);
    EXPECT_NE(std::string(start(scene, {quality_preset(), by_steps}).error().c_str()).find("two different"), std::string::npos);
    TraceSettings stored = by_steps;
    stored.is_surface_stored = true;
    EXPECT_NE(std::string(start(scene, {stored}).error().c_str()).find("searched exactly only"), std::string::npos);
    by_steps.search = usual_search(SearchKind::cones);
    EXPECT_NE(std::string(start(scene, {by_steps}).error().c_str()).find("cones stand over a bilinear"), std::string::npos);
    size_.width = 20000;
    EXPECT_NE(std::string(start(scene, {time_preset()}, 1 << 20).error().c_str()).find("16384"), std::string::npos);
    size_.width = 100;
    posts_.at(3, 3) = 32767;
    EXPECT_NE(std::string(start(scene, {quality_preset()}).error().c_str()).find("16 bits"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::raytrace
