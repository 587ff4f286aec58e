/// Small scenes with every shape of layer, for tests that read, damage or draw them.
#pragma once

#include <cmath>
#include <limits>

#include "host_sim/scene_builder/sdb_writer.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::test_support {

inline scene::ScenePoint scene_point(double latitude_deg, double longitude_deg, float height_m) {
    return {base::radians(latitude_deg), base::radians(longitude_deg), height_m, 0, scene::kNoTime};
}

/// 4 x 3 posts on two levels at two times, a value of its own each; one missing, one interpolated.
inline host_sim::LayerDraft small_grid() {
    host_sim::LayerDraft layer;
    layer.name = "air";
    layer.title = "AIR";
    layer.source = "made for a test";
    layer.shape = scene::LayerShape::grid;
    layer.grid = {base::radians(9), base::radians(47), base::radians(0.25), base::radians(0.5), 4, 3, 2, 2};
    layer.levels_m = {1000, 3000};
    layer.times_ns = {0, 3'600'000'000'000};
    host_sim::AttributeDraft temperature;
    temperature.name = "temperature";
    temperature.unit = "K";
    temperature.uncertainty_kind = scene::UncertaintyKind::standard_deviation;
    temperature.uncertainty_full = 4;
    for (int n = 0; n < 48; ++n) {
        temperature.values.push_back(260 + static_cast<float>(n));
        temperature.uncertainties.push_back(scene::Uncertainty::from_level(n / 60.0));
        temperature.states.push_back(n == 7 ? scene::ValueState::interpolated : scene::ValueState::valid);
    }
    temperature.values[5] = std::numeric_limits<float>::quiet_NaN();
    layer.attributes.push_back(temperature);
    return layer;
}

/// The same of an ensemble: n members, (m - (n - 1) / 2) * 10 apart from their mean, which is the value.
inline host_sim::LayerDraft small_ensemble(int members = 3) {
    host_sim::LayerDraft layer = small_grid();
    host_sim::AttributeDraft& temperature = layer.attributes[0];
    for (int m = 0; m < members; ++m) {
        std::vector<float> values = temperature.values;
        for (float& value : values) value += 10 * (static_cast<float>(m) - static_cast<float>(members - 1) / 2);
        temperature.members.push_back(values);
    }
    return layer;
}

/// Three masts, with a height and a kind.
inline host_sim::LayerDraft small_points() {
    host_sim::LayerDraft layer;
    layer.name = "masts";
    layer.role = scene::LayerRole::obstacle;
    layer.height_datum = scene::HeightDatum::ground;
    layer.points = {scene_point(46.8, 9.8, 40), scene_point(46.81, 9.81, std::numeric_limits<float>::quiet_NaN()),
                    scene_point(46.82, 9.83, 120)};
    layer.names = {"Mast A", "", "Sendemast Schw\xC3\xA4galp Nord"};
    layer.position_accuracy_m = 5;
    host_sim::AttributeDraft kind;
    kind.name = "kind";
    kind.scale = scene::AttributeScale::nominal;
    kind.of = scene::AttributeOf::feature;
    kind.classes = {"mast", "turbine"};
    kind.values = {0, 1, 0};
    kind.uncertainty_all = scene::Uncertainty::from_level(0);
    layer.attributes.push_back(kind);
    return layer;
}

/// Two areas of three and four points.
inline host_sim::LayerDraft small_areas() {
    host_sim::LayerDraft layer;
    layer.name = "zones";
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::no_go;
    for (int n = 0; n < 7; ++n) layer.points.push_back(scene_point(46.8 + 0.01 * n, 9.8 + 0.02 * (n % 3), 3000));
    layer.starts = {0, 3, 7};
    host_sim::AttributeDraft floor;
    floor.name = "floor";
    floor.unit = "m";
    floor.of = scene::AttributeOf::feature;
    floor.values = {1500, 2000};
    layer.attributes.push_back(floor);
    return layer;
}

/// One model, a tetrahedron, at two places.
inline host_sim::LayerDraft small_meshes() {
    host_sim::LayerDraft layer;
    layer.name = "huts";
    layer.shape = scene::LayerShape::meshes;
    layer.role = scene::LayerRole::model;
    layer.points = {scene_point(46.8, 9.8, 1600), scene_point(46.9, 9.9, 1700)};
    for (const auto& [x, y, z] : {std::array<float, 3>{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}})
        layer.model.vertices.push_back({{x, y, z}, {0, 0, 127, 0}, {200, 180, 90, 255}});
    layer.model.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return layer;
}

inline host_sim::SceneDraft small_scene() {
    host_sim::SceneDraft scene;
    scene.name = "small";
    scene.origin = "made for a test";
    scene.layers = {small_grid(), small_points(), small_areas(), small_meshes()};
    return scene;
}

}  // namespace tedavis::test_support
