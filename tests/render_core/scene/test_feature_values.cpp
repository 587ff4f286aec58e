#include "render_core/scene/feature_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/draw/built_element.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::scene::test_feature_values {
namespace {

TEST(FeatureValues, ThatAreNotThereAreNaN) {
    const test_support::LoadedScene scene(test_support::small_points());
    EXPECT_EQ(value_or_nan(scene.layer(), "kind", 1), 1);
    EXPECT_TRUE(std::isnan(value_or_nan(scene.layer(), "kind", 3)));
    EXPECT_TRUE(std::isnan(value_or_nan(scene.layer(), "colour", 0)));
}

TEST(FeatureValues, AFeatureDriftsFromTheDatasTime) {
    host_sim::LayerDraft draft = test_support::small_points();
    const auto bind = [&](const char* name, float value) {
        host_sim::AttributeDraft attribute;
        attribute.name = name;
        attribute.of = AttributeOf::feature;
        attribute.values.assign(draft.starts.empty() ? draft.points.size() : draft.starts.size() - 1, value);
        draft.attributes.push_back(attribute);
    };
    bind("speed", 10);
    bind("toward", 1.5707963f);
    draft.data_time_ns = 1'000'000'000;
    const test_support::LoadedScene scene(draft);
    constexpr std::int64_t kMinuteLater_ns = 61'000'000'000;
    const glm::dvec2 gone = drift_m(scene.layer(), 0, kMinuteLater_ns, true);
    EXPECT_NEAR(gone.x, 600, 0.01) << "to the east";
    EXPECT_NEAR(gone.y, 0, 0.01);
    EXPECT_EQ(drift_m(scene.layer(), 0, kMinuteLater_ns, false), glm::dvec2(0)) << "without a date it stays";
}

}  // namespace
}  // namespace tedavis::scene::test_feature_values
