/// A crowd of data over the hills, for tests of the budget of clutter.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "render_core/effects/clutter_budget.hpp"
#include "tests/support/scene/map_scene.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::test_support {

/// 1000 samples in the air ahead of the aircraft over the hills, and names on the ground.
inline const std::vector<std::uint8_t>& crowd() {
    static const std::vector<std::uint8_t> kBytes = [] {
        std::uint32_t state = 7;
        const auto next = [&] { return static_cast<double>((state = state * 1664525u + 1013904223u) >> 8) / (1u << 24); };
        host_sim::LayerDraft samples, places;
        samples.name = "samples";
        samples.role = scene::LayerRole::sample;
        host_sim::AttributeDraft dose;
        dose.name = "dose";
        for (int n = 0; n < 1000; ++n) {
            samples.points.push_back(
                scene_point(47.01 + 0.07 * next(), 9.69 + 0.12 * next(), static_cast<float>(1100 + 1500 * next())));
            dose.values.push_back(static_cast<float>(next()));
        }
        samples.attributes = {dose};
        places.name = "places";
        places.role = scene::LayerRole::place;
        for (int n = 0; n < 60; ++n) {
            places.points.push_back(scene_point(47.01 + 0.05 * next(), 9.7 + 0.06 * next(), std::nanf("")));
            places.names.push_back("Ort " + std::to_string(n));
        }
        return host_sim::sdb_bytes({"crowd", "a test", 1, {samples, places}});
    }();
    return kBytes;
}

/// A design that shows the crowd, without symbology. `budget`: the clutter that it allows in a region; 1: no budget is held.
/// `data`: the weight of the data, which are not reduced where it is the largest.
inline design::DesignSettings crowd_design(double budget, double data = 0.5) {
    design::DesignSettings design = without_symbols(shipped_design("default"));
    design.data = {};
    design.foci = {};
    design.effects = {};
    design.warning_colors = false;
    design.priority = {};
    design.priority.is_stated = true;
    design.priority.weights.of[design::kDataAspect] = data;
    for (const double at : {0.0, 1.0}) EXPECT_TRUE(design.priority.data.knots.try_push_back({at, 1}));
    design.priority.clutter_budget = budget;
    design::DataElement spheres, names;
    spheres.role = scene::LayerRole::sample;
    spheres.technique = design::DataTechnique::spheres;
    spheres.by_color.attribute = "dose";
    EXPECT_TRUE(spheres.by_color.scale.palette.stops.try_push_back({0, {255, 255, 80}}));
    EXPECT_TRUE(spheres.by_color.scale.palette.stops.try_push_back({1, {40, 0, 120}}));
    spheres.size_m = 150;
    names.role = scene::LayerRole::place;
    names.technique = design::DataTechnique::billboard;
    EXPECT_TRUE(design.data.elements.try_push_back(spheres));
    EXPECT_TRUE(design.data.elements.try_push_back(names));
    return design;
}

/// A measurement that is the same in all regions.
inline effects::ClutterMap clutter_of(float measure) {
    effects::ClutterMap map;
    map.is_known = true;
    map.measure.fill(measure);
    return map;
}

}  // namespace tedavis::test_support
