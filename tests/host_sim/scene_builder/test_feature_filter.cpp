#include "host_sim/scene_builder/feature_filter.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_feature_filter {
namespace {

using scene::LayerRole;
using scene::LayerShape;

SourceFeature through(const std::vector<std::pair<double, double>>& places_deg) {
    SourceFeature feature;
    for (const auto& [latitude, longitude] : places_deg) feature.points.push_back({latitude, longitude, {}, {}});
    return feature;
}

TEST(FeatureFilter, RolesAskForTheirShape) {
    for (const LayerRole role :
         {LayerRole::trajectory, LayerRole::traffic, LayerRole::ghost, LayerRole::runway, LayerRole::road, LayerRole::river})
        EXPECT_EQ(shape_of(role, {}), LayerShape::lines);
    for (const LayerRole role : {LayerRole::no_go, LayerRole::airspace, LayerRole::storm_cell, LayerRole::building})
        EXPECT_EQ(shape_of(role, {}), LayerShape::areas);
    for (const LayerRole role : {LayerRole::obstacle, LayerRole::place, LayerRole::sample, LayerRole::wind})
        EXPECT_EQ(shape_of(role, {}), LayerShape::points);
    SourceFeature cable = through({{46, 9}, {46, 10}}), mast = through({{46, 9}});
    cable.shape = LayerShape::lines;
    EXPECT_EQ(shape_of(LayerRole::obstacle, {cable}), LayerShape::lines);
    EXPECT_EQ(shape_of(LayerRole::obstacle, {cable, mast}), LayerShape::points);
    EXPECT_EQ(shape_of(LayerRole::no_go, {cable, mast}), LayerShape::areas);
}

TEST(FeatureFilter, RegionsAreReachedByWhatTouchesThem) {
    const RegionRecipe alps{9, 46, 10, 47};
    EXPECT_TRUE(reaches(through({{46.5, 9.5}}), alps));
    EXPECT_TRUE(reaches(through({{46, 9}}), alps)) << "its corner belongs to it";
    for (const auto& [latitude, longitude] : {std::pair{45.9, 9.5}, {47.1, 9.5}, {46.5, 8.9}, {46.5, 10.1}})
        EXPECT_FALSE(reaches(through({{latitude, longitude}}), alps)) << latitude << ' ' << longitude;
    EXPECT_TRUE(reaches(through({{45, 8}, {45, 11}, {48, 11}, {48, 8}}), alps)) << "an area round it has no point in it";
    EXPECT_TRUE(reaches(through({{46.5, 8}, {46.5, 11}}), alps)) << "a line across it";
    EXPECT_FALSE(reaches(through({}), alps));
}

TEST(FeatureFilter, RegionsMayLieAcrossTheAntimeridian) {
    const RegionRecipe fiji{177, -20, -178, -15};
    EXPECT_TRUE(reaches(through({{-17, 178}}), fiji));
    EXPECT_TRUE(reaches(through({{-17, -179}}), fiji));
    EXPECT_FALSE(reaches(through({{-17, 0}}), fiji));
    EXPECT_FALSE(reaches(through({{-17, -177}}), fiji));
    EXPECT_TRUE(reaches(through({{-17, 176}, {-17, -176}}), fiji)) << "by the short way";
    EXPECT_FALSE(reaches(through({{-17, 10}, {-17, 20}}), fiji));
    EXPECT_TRUE(reaches(through({{-17, 178}}), {170, -20, 190, -15}));
    EXPECT_TRUE(reaches(through({{-17, -175}}), {170, -20, 190, -15}));
}

TEST(FeatureFilter, TimesAreKeptWithTheirValues) {
    SourceFeature flight = through({{1, 0}, {2, 0}, {3, 0}, {4, 0}});
    for (int n = 0; n < 3; ++n) flight.points[static_cast<std::size_t>(n)].time_ns = 100 * n;
    flight.point_values["speed"] = {10, 11, 12, 13};
    SourceFeature all = flight;
    keep_times(all, {}, {});
    EXPECT_EQ(all.points.size(), 4u);
    keep_times(flight, 100, 150);
    ASSERT_EQ(flight.points.size(), 2u) << "what has no time stays";
    EXPECT_EQ(flight.points[0].latitude_deg, 2);
    EXPECT_EQ(flight.point_values["speed"], (std::vector<double>{11, 13}));
    keep_times(flight, 200, 300);
    EXPECT_EQ(flight.point_values["speed"], (std::vector<double>{13}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_feature_filter
