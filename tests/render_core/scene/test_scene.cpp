#include "render_core/scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/loaded_scene.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::scene::test_scene {
namespace {

using test_support::FlakyBytes;

struct Loaded {
    explicit Loaded(const host_sim::SceneDraft& draft, std::size_t bytes = 1 << 16)
        : source(host_sim::sdb_bytes(draft)),
          memory(bytes),
          arena(memory.data(), memory.size()),
          result(Scene::load(source, arena)) {}

    FlakyBytes source;
    std::vector<std::uint8_t> memory;
    base::Arena arena;
    base::Result<Scene, SdbFailure> result;
};

TEST(Scene, EveryShapeComesBackAsWritten) {
    const host_sim::SceneDraft draft = test_support::small_scene();
    Loaded loaded(draft);
    ASSERT_TRUE(loaded.result.ok()) << describe(loaded.result.error()).view();
    const Scene& scene = loaded.result.value();
    ASSERT_EQ(scene.layers().size(), draft.layers.size());
    EXPECT_STREQ(scene.header().name, "small");
    for (const host_sim::LayerDraft& wanted : draft.layers) {
        const Layer* const layer = scene.find(wanted.name);
        ASSERT_NE(layer, nullptr) << wanted.name;
        EXPECT_EQ(layer->entry->shape, wanted.shape);
        EXPECT_EQ(layer->points.size(), wanted.points.size());
        EXPECT_EQ(layer->starts.size(), wanted.starts.size());
        EXPECT_EQ(layer->triangles.size(), 3 * wanted.model.triangles.size());
        ASSERT_EQ(layer->attributes.size(), wanted.attributes.size());
        for (const host_sim::AttributeDraft& a : wanted.attributes) {
            const Attribute* const attribute = layer->find(a.name);
            ASSERT_NE(attribute, nullptr) << a.name;
            for (std::size_t n = 0; n < a.values.size(); ++n) {
                const bool both_missing = std::isnan(a.values[n]) && std::isnan(attribute->values[n]);
                EXPECT_TRUE(both_missing || attribute->values[n] == a.values[n]) << a.name << " " << n;
            }
        }
    }
    EXPECT_EQ(scene.find("nothing"), nullptr);
    EXPECT_EQ(scene.layers()[0].find("nothing"), nullptr);
}

TEST(Scene, ValuesHaveStatesAndUncertainties) {
    Loaded loaded(test_support::small_scene());
    ASSERT_TRUE(loaded.result.ok());
    const Attribute& temperature = *loaded.result.value().find("air")->find("temperature");
    EXPECT_EQ(temperature.state(5), ValueState::missing);
    EXPECT_EQ(temperature.state(7), ValueState::interpolated);
    EXPECT_EQ(temperature.state(8), ValueState::valid);
    EXPECT_FALSE(temperature.uncertainty(5).is_known()) << "nothing is sure of what is missing";
    EXPECT_NEAR(temperature.uncertainty(30).level(), 0.5, 1.0 / 254);
    EXPECT_EQ(temperature.entry->minimum, 260);
    EXPECT_EQ(temperature.entry->maximum, 307);
    const Attribute& kind = *loaded.result.value().find("masts")->find("kind");
    EXPECT_EQ(kind.uncertainty(2).level(), 0) << "one for the whole attribute";
    EXPECT_EQ(kind.class_name(1), "turbine");
    EXPECT_EQ(kind.class_name(7), "");
    EXPECT_FALSE(loaded.result.value().find("zones")->find("floor")->uncertainty(0).is_known()) << "what is not stated";
}

TEST(Scene, FeaturesHaveRunsOfPointsAndNames) {
    Loaded loaded(test_support::small_scene());
    ASSERT_TRUE(loaded.result.ok());
    const Layer &zones = *loaded.result.value().find("zones"), &masts = *loaded.result.value().find("masts");
    EXPECT_EQ(zones.points_of(1).first, 3u);
    EXPECT_EQ(zones.points_of(1).count, 4u);
    EXPECT_EQ(masts.points_of(2).first, 2u);
    EXPECT_EQ(masts.points_of(2).count, 1u);
    EXPECT_EQ(masts.name_of(0), "Mast A");
    EXPECT_EQ(masts.name_of(1), "");
    EXPECT_EQ(masts.name_of(2), "Sendemast Schw\xC3\xA4galp No") << "cut to its field";
    EXPECT_EQ(zones.name_of(0), "");
}

TEST(Scene, AnEmptyOneIsSound) {
    Loaded loaded({});
    ASSERT_TRUE(loaded.result.ok());
    EXPECT_TRUE(loaded.result.value().layers().empty());
}

TEST(Scene, WhatDoesNotFitTheBudgetIsRefusedAndSaid) {
    Loaded loaded(test_support::small_scene(), 2000);
    ASSERT_FALSE(loaded.result.ok());
    EXPECT_EQ(loaded.result.error().error, SdbError::too_large);
    EXPECT_NE(describe(loaded.result.error()).view().find("scene_data"), std::string_view::npos);
}

TEST(Scene, EveryFaultHasASentenceThatSaysWhatToDo) {
    for (const SdbError error : {SdbError::unreadable, SdbError::not_an_sdb, SdbError::wrong_version, SdbError::truncated,
                                 SdbError::damaged, SdbError::too_large}) {
        const base::FixedString<191> text = describe({error, 18446744073709551615u});
        EXPECT_NE(text.view().find("; "), std::string_view::npos) << text.view();
        EXPECT_LT(text.size(), 190u);
    }
}

TEST(Scene, AMemberIsItsOwnValuesWithWhatTheEnsembleHas) {
    const test_support::LoadedScene loaded(test_support::small_ensemble(5));
    const Attribute& mean = loaded.attribute();
    ASSERT_EQ(mean.member_count(), 5u);
    EXPECT_EQ(mean.entry->minimum, 260 - 20) << "limits are of the members too";
    EXPECT_EQ(mean.entry->maximum, 307 + 20);
    for (std::uint32_t n = 0; n < 5; ++n) {
        const Attribute member = mean.member(n);
        for (std::size_t post = 0; post < 48; ++post) {
            EXPECT_EQ(member.state(post), mean.state(post));
            EXPECT_EQ(member.uncertainty(post), mean.uncertainty(post));
            if (post == 5) continue;
            EXPECT_EQ(member.values[post], mean.values[post] + 10 * static_cast<float>(n) - 20);
        }
    }
    EXPECT_EQ(test_support::LoadedScene(test_support::small_grid()).attribute().member_count(), 0u);
}

}  // namespace
}  // namespace tedavis::scene::test_scene
