#include "render_core/policy/declutter.hpp"

#include <gtest/gtest.h>

namespace tedavis::policy::test_declutter {
namespace {

using scene::LayerRole;

scene::DetailRegions crowded(std::size_t region) {
    scene::DetailRegions regions;
    regions.factor[region] = 0.5f;
    return regions;
}

/// Terrain first, then obstacles, then all other data.
design::PrioritySettings priority_of(double terrain, double data, double obstacles) {
    design::PrioritySettings priority;
    priority.is_stated = true;
    priority.weights.of[design::kTerrainAspect] = terrain;
    priority.weights.of[design::kDataAspect] = data;
    priority.weights.of[design::kUncertaintyAspect] = 0.2;
    priority.weights.of[design::kMainAspects] = obstacles;
    design::DataPart part;
    part.roles = 1u << static_cast<unsigned>(LayerRole::obstacle);
    EXPECT_TRUE(priority.parts.try_push_back(part));
    return priority;
}

bool may_declutter(const Declutter& declutter, LayerRole role, design::DataTechnique technique = design::DataTechnique::arrows) {
    design::DataElement element;
    element.technique = technique;
    EXPECT_EQ(declutter.regions_of(element, role, true), nullptr) << "what warns";
    return declutter.regions_of(element, role, false) != nullptr;
}

TEST(Declutter, WhatComesFirstNeverGivesWay) {
    const scene::DetailRegions map = crowded(9);
    const design::PrioritySettings data = priority_of(0.3, 1, 0.5), terrain = priority_of(1, 0.3, 1);
    const Declutter in_cruise = declutter_of(map, data, data.weights), low = declutter_of(map, terrain, terrain.weights);
    EXPECT_FALSE(may_declutter(in_cruise, LayerRole::wind));
    EXPECT_TRUE(may_declutter(in_cruise, LayerRole::obstacle));
    EXPECT_TRUE(may_declutter(low, LayerRole::wind));
    EXPECT_FALSE(may_declutter(low, LayerRole::obstacle)) << "as first as terrain";
    EXPECT_TRUE(may_declutter(in_cruise, LayerRole::wind, design::DataTechnique::uncertainty_only));
    design::AspectWeights unsure = data.weights;
    unsure.of[design::kUncertaintyAspect] = 1;
    EXPECT_FALSE(may_declutter(declutter_of(map, data, unsure), LayerRole::wind, design::DataTechnique::uncertainty_only))
        << "raised for the moment";
}

TEST(Declutter, WhereAllRegionsKeepAllNothingGivesWay) {
    const design::PrioritySettings priority = priority_of(1, 0.3, 0.3);
    EXPECT_FALSE(may_declutter(declutter_of({}, priority, priority.weights), LayerRole::wind));
    EXPECT_TRUE(may_declutter(declutter_of(crowded(9), priority, priority.weights), LayerRole::wind)) << "control";
}

TEST(Declutter, AtMostEverythingButWhatComesFirstKeepsTheLeast) {
    const design::PrioritySettings priority = priority_of(1, 0.3, 1);
    const Declutter most = declutter_of(effects::least_detail(), priority, priority.weights);
    for (const float factor : most.regions.factor) EXPECT_EQ(factor, static_cast<float>(effects::kMinDetailLeft));
    EXPECT_TRUE(may_declutter(most, LayerRole::wind));
    EXPECT_FALSE(may_declutter(most, LayerRole::obstacle));
}

}  // namespace
}  // namespace tedavis::policy::test_declutter
