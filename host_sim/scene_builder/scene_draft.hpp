/// A scene before it is written: the layers of a .sdb as vectors. SI and radians, as in sdb_format.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render_core/scene/sdb_format.hpp"

namespace tedavis::host_sim {

struct AttributeDraft {
    std::string name, title, unit;
    scene::AttributeScale scale = scene::AttributeScale::quantitative;
    scene::AttributeOf of = scene::AttributeOf::point;
    std::vector<std::string> classes;
    std::vector<float> values;                      ///< NaN where missing
    std::vector<scene::Uncertainty> uncertainties;  ///< empty: all have uncertainty_all
    std::vector<scene::ValueState> states;          ///< empty: none is interpolated
    std::vector<std::vector<float>> members;        ///< values of the members of an ensemble, as many each; NaN where missing
    scene::Uncertainty uncertainty_all;
    scene::UncertaintyKind uncertainty_kind = scene::UncertaintyKind::none;
    scene::UncertaintyScope uncertainty_scope = scene::UncertaintyScope::value;
    std::string derived_from;                     ///< the layer from whose values it was computed; empty: its own
    std::optional<std::int64_t> derived_time_ns;  ///< time of those values; nothing: each is of its point's own time
    double uncertainty_full = 0;
    double uncertainty_growth_per_hour = 0;
};

struct ModelDraft {
    std::vector<scene::ModelVertex> vertices;
    std::vector<std::array<std::uint16_t, 3>> triangles;
};

struct LayerDraft {
    std::string name, title, source;
    scene::LayerShape shape = scene::LayerShape::points;
    scene::LayerRole role = scene::LayerRole::field;
    scene::HeightDatum height_datum = scene::HeightDatum::msl;
    std::uint8_t importance = 128;
    std::int64_t data_time_ns = scene::kNoTime;
    std::int64_t valid_from_ns = INT64_MIN, valid_until_ns = INT64_MAX;
    double position_accuracy_m = 0, height_accuracy_m = 0;
    scene::GridShape grid{};             ///< of a grid, whose `points` are empty
    std::vector<float> levels_m;         ///< empty: one level, at any height
    std::vector<std::int64_t> times_ns;  ///< empty: one time, at any time
    std::vector<scene::ScenePoint> points;
    std::vector<std::uint32_t> starts;  ///< of lines and areas: index of the first point of each, and the number of points
    std::vector<std::string> names;     ///< of features; empty: none has one
    ModelDraft model;
    std::vector<AttributeDraft> attributes;

    [[nodiscard]] std::uint64_t point_count() const {
        return shape == scene::LayerShape::grid ? std::uint64_t{grid.columns} * grid.rows * grid.levels * grid.times
                                                : points.size();
    }
    [[nodiscard]] std::uint64_t feature_count() const {
        const bool has_runs = shape == scene::LayerShape::lines || shape == scene::LayerShape::areas;
        return has_runs ? (starts.empty() ? 0 : starts.size() - 1) : point_count();
    }
};

struct SceneDraft {
    std::string name, origin;
    std::uint64_t revision = 1;
    std::vector<LayerDraft> layers;
};

}  // namespace tedavis::host_sim
