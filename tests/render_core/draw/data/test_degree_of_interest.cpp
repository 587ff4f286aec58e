#include "render_core/draw/data/degree_of_interest.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::draw::test_degree_of_interest {
namespace {

using test_support::LoadedScene;

host_sim::LayerDraft places(std::size_t count, scene::LayerRole role = scene::LayerRole::place) {
    host_sim::LayerDraft layer;
    layer.name = "places";
    layer.role = role;
    for (std::size_t n = 0; n < count; ++n) layer.points.push_back({0.8, 0.1 + 0.001 * n, 0, 0, scene::kNoTime});
    return layer;
}

host_sim::AttributeDraft values(const std::string& name, const std::vector<float>& of_features) {
    host_sim::AttributeDraft attribute;
    attribute.name = name;
    attribute.of = scene::AttributeOf::feature;
    attribute.values = of_features;
    return attribute;
}

design::LabelSettings only(double distance, double population, double height, double runway_length, double relevance) {
    design::LabelSettings settings;
    settings.weights = {distance, population, height, runway_length, relevance};
    return settings;
}

TEST(DegreeOfInterest, DistancesCountByTheirLogarithm) {
    const LoadedScene scene(places(1));
    const design::LabelSettings settings = only(1, 0, 0, 0, 0);
    const DegreeOfInterest interest(scene.layer(), settings);
    EXPECT_DOUBLE_EQ(interest.of(0, 0), 1);
    EXPECT_DOUBLE_EQ(interest.of(0, 80'000), 0);
    EXPECT_DOUBLE_EQ(interest.of(0, 500'000), 0);
    EXPECT_NEAR(interest.of(0, 8000), 0.5, 1e-12) << "ln 9 is half of ln 81";
    EXPECT_NEAR(interest.of(0, 2000), 0.75, 1e-12) << "ln 3 is a quarter";
}

TEST(DegreeOfInterest, PeopleCountByTheirLogarithmToo) {
    host_sim::LayerDraft layer = places(5);
    layer.attributes = {values("population", {50, 100, 10'000, 2'000'000, std::numeric_limits<float>::quiet_NaN()})};
    const LoadedScene scene(layer);
    const design::LabelSettings settings = only(0, 1, 0, 0, 0);
    const DegreeOfInterest interest(scene.layer(), settings);
    const double expected[] = {0, 0, 0.5, 1, 0.5};
    for (std::uint32_t n = 0; n < 5; ++n) EXPECT_NEAR(interest.of(n, 0), expected[n], 1e-12) << n;
}

TEST(DegreeOfInterest, ClassesStandForPeopleWhereNoneAreStated) {
    host_sim::LayerDraft layer = places(4);
    host_sim::AttributeDraft kind = values("kind", {0, 1, 2, std::numeric_limits<float>::quiet_NaN()});
    kind.scale = scene::AttributeScale::ordinal;
    kind.classes = {"hamlet", "village", "town"};
    layer.attributes = {kind};
    const design::LabelSettings settings = only(0, 1, 0, 0, 0);
    const LoadedScene scene(layer);
    const DegreeOfInterest interest(scene.layer(), settings);
    const double expected[] = {0, 0.5, 1, 0.5};
    for (std::uint32_t n = 0; n < 4; ++n) EXPECT_NEAR(interest.of(n, 0), expected[n], 1e-12) << n;
    layer.attributes[0].scale = scene::AttributeScale::nominal;
    layer.attributes.push_back(values("population", {1'000'000, 1, 1, 1}));
    const LoadedScene stated(layer);
    EXPECT_NEAR(DegreeOfInterest(stated.layer(), settings).of(0, 0), 1, 1e-12) << "who states people needs no class";
}

TEST(DegreeOfInterest, HeightsAreOfTheLargestAndRunwaysOfALongOne) {
    host_sim::LayerDraft peaks = places(3);
    peaks.attributes = {values("elevation", {4000, 1000, 0})};
    const LoadedScene high(peaks);
    const design::LabelSettings by_height = only(0, 0, 1, 0, 0), by_length = only(0, 0, 0, 1, 0);
    EXPECT_NEAR(DegreeOfInterest(high.layer(), by_height).of(0, 0), 1, 1e-12);
    EXPECT_NEAR(DegreeOfInterest(high.layer(), by_height).of(1, 0), 0.25, 1e-12);
    host_sim::LayerDraft strips = places(4, scene::LayerRole::runway);
    strips.shape = scene::LayerShape::lines;
    strips.starts = {0, 2, 4};
    strips.attributes = {values("length", {1200, 3600})};
    const LoadedScene runways(strips);
    EXPECT_NEAR(DegreeOfInterest(runways.layer(), by_length).of(0, 0), 0.4, 1e-7);
    EXPECT_NEAR(DegreeOfInterest(runways.layer(), by_length).of(1, 0), 1, 1e-12);
}

/// (1 x 0.5 + 0.5 x 0.5 + 2 x 0.9) / 3.5, and without the people (0.5 + 1.8) / 3.
TEST(DegreeOfInterest, IsTheWeightedMeanOfWhatTheLayerStates) {
    host_sim::LayerDraft layer = places(1);
    design::LabelSettings settings = only(1, 0.5, 7, 7, 2);
    settings.relevance[6] = 0.9;
    ASSERT_EQ(design::kLabelRoles[6], scene::LayerRole::place);
    const LoadedScene bare(layer);
    EXPECT_NEAR(DegreeOfInterest(bare.layer(), settings).of(0, 8000), 2.3 / 3, 1e-12);
    layer.attributes = {values("population", {10'000})};
    const LoadedScene stated(layer);
    EXPECT_NEAR(DegreeOfInterest(stated.layer(), settings).of(0, 8000), 2.55 / 3.5, 1e-12);
}

/// A phase's design alone turns the order round.
TEST(DegreeOfInterest, ThePhaseDecidesWhatMatters) {
    const LoadedScene town(places(1)), strip(places(1, scene::LayerRole::obstacle));
    design::LabelSettings cruise, approach;
    cruise.relevance[6] = 1;
    cruise.relevance[1] = 0.2;
    approach.relevance[6] = 0.2;
    const auto of = [](const LoadedScene& scene, const design::LabelSettings& settings) {
        return DegreeOfInterest(scene.layer(), settings).of(0, 5000);
    };
    EXPECT_GT(of(town, cruise), of(strip, cruise));
    EXPECT_LT(of(town, approach), of(strip, approach));
}

}  // namespace
}  // namespace tedavis::draw::test_degree_of_interest
