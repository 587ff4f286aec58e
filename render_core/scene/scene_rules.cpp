#include "render_core/scene/scene_rules.hpp"

#include <cmath>
#include <initializer_list>

#include "render_core/base/units.hpp"

namespace tedavis::scene {
namespace {

constexpr double kRounding_rad = 1e-9;
constexpr double kHighest_m = 100000;  // of anything that is shown
constexpr double kFarthest_m = 10000;  // from a model's point
constexpr float kLargestValue = 1e30F;
constexpr std::uint64_t kMaxPosts = 1u << 28;

bool within(double value, double low, double high) { return value >= low && value <= high; }

bool is_latitude(double angle_rad) { return std::abs(angle_rad) <= 0.5 * base::kPi + kRounding_rad; }
bool is_longitude(double angle_rad) { return std::abs(angle_rad) <= base::kPi + kRounding_rad; }

/// Counts are multiplied one by one, so that no product overflows.
bool posts_are(const GridShape& grid, std::uint64_t count) {
    std::uint64_t posts = 1;
    for (const std::uint32_t side : {grid.columns, grid.rows, grid.levels, grid.times}) {
        if (side == 0 || posts > kMaxPosts / side) return false;
        posts *= side;
    }
    return posts == count;
}

bool grid_holds(const LayerEntry& e) {
    const GridShape& g = e.grid;
    const bool steps = g.step_lon_rad > 0 && g.step_lat_rad > 0 && g.step_lon_rad <= base::kPi && g.step_lat_rad <= base::kPi;
    return steps && posts_are(g, e.point_count) && e.feature_count == e.point_count && is_longitude(g.west_rad) &&
           is_latitude(g.north_rad) && is_latitude(g.north_rad - g.step_lat_rad * (g.rows - 1.0)) &&
           g.step_lon_rad * (g.columns - 1.0) <= 2 * base::kPi + kRounding_rad;
}

bool counts_hold(const LayerEntry& e) {
    switch (e.shape) {
        case LayerShape::grid: return grid_holds(e);
        case LayerShape::points: return e.feature_count == e.point_count;
        case LayerShape::lines:
        case LayerShape::areas: return e.feature_count <= e.point_count;
        case LayerShape::meshes:
            return e.feature_count == e.point_count && e.vertex_count >= 3 && e.vertex_count <= 0x10000 && e.triangle_count >= 1;
    }
    return false;
}

}  // namespace

std::uint32_t least_points(LayerShape shape) { return shape == LayerShape::areas ? 3 : 1; }

bool entry_holds(const LayerEntry& e, std::uint32_t all_attributes) {
    const bool texts = ends(e.name) && ends(e.title) && ends(e.source) && e.name[0] != 0;
    const bool kinds = e.role < LayerRole::count && e.height_datum <= HeightDatum::ground;
    const bool attributes = e.first_attribute <= all_attributes && e.attribute_count <= all_attributes - e.first_attribute;
    const bool accuracies = e.position_accuracy_m >= 0 && e.position_accuracy_m < kLargestValue && e.height_accuracy_m >= 0 &&
                            e.height_accuracy_m < kLargestValue;
    return texts && kinds && attributes && accuracies && e.valid_from_ns <= e.valid_until_ns && counts_hold(e);
}

bool entry_holds(const AttributeEntry& e, const LayerEntry& layer) {
    const bool texts = ends(e.name) && ends(e.title) && ends(e.unit) && e.name[0] != 0;
    const bool kinds = e.scale <= AttributeScale::quantitative && e.of <= AttributeOf::point &&
                       e.uncertainty_kind <= UncertaintyKind::ordinal && e.uncertainty_scope <= UncertaintyScope::data_set;
    const bool is_classed = e.scale != AttributeScale::quantitative;
    const bool classes = is_classed ? e.class_count >= 1 && e.class_count <= kMaxClasses : e.class_count == 0;
    const bool limits = within(e.minimum, -kLargestValue, e.maximum) && within(e.maximum, e.minimum, kLargestValue) &&
                        within(e.uncertainty_full, 0, kLargestValue) && within(e.uncertainty_growth_per_hour, 0, kLargestValue);
    // A mean of classes is none.
    const bool members = e.member_count == 0 ||
                         (!is_classed && e.member_count >= 2 && e.member_count <= kMaxMembers && layer.shape == LayerShape::grid);
    const std::uint64_t values = e.of == AttributeOf::feature ? layer.feature_count : layer.point_count;
    return texts && kinds && classes && limits && members && e.value_count == values;
}

bool points_hold(base::Span<const ScenePoint> points) {
    for (const ScenePoint& p : points) {
        const bool height = std::isnan(p.height_m) || std::abs(p.height_m) <= kHighest_m;
        if (!is_latitude(p.latitude_rad) || !is_longitude(p.longitude_rad) || !height) return false;
    }
    return true;
}

bool starts_hold(base::Span<const std::uint32_t> starts, std::uint32_t point_count, std::uint32_t least) {
    if (starts.empty() || starts[0] != 0 || starts[starts.size() - 1] != point_count) return false;
    for (std::size_t n = 1; n < starts.size(); ++n)
        if (starts[n] < starts[n - 1] || starts[n] - starts[n - 1] < least) return false;
    return true;
}

bool levels_hold(base::Span<const float> levels_m) {
    for (std::size_t n = 0; n < levels_m.size(); ++n)
        if (!(std::abs(levels_m[n]) <= kHighest_m) || (n > 0 && !(levels_m[n] > levels_m[n - 1]))) return false;
    return true;
}

bool times_hold(base::Span<const std::int64_t> times_ns) {
    for (std::size_t n = 1; n < times_ns.size(); ++n)
        if (times_ns[n] <= times_ns[n - 1]) return false;
    return true;
}

bool names_hold(base::Span<const char> names) {
    for (std::size_t n = kNameBytes - 1; n < names.size(); n += kNameBytes)
        if (names[n] != 0) return false;
    return true;
}

bool model_holds(base::Span<const ModelVertex> vertices, base::Span<const std::uint16_t> triangles) {
    for (const ModelVertex& v : vertices)
        for (const float m : v.place_m)
            if (!(std::abs(m) <= kFarthest_m)) return false;
    for (const std::uint16_t index : triangles)
        if (index >= vertices.size()) return false;
    return true;
}

bool values_hold(base::Span<const float> values, const AttributeEntry& entry) {
    const bool is_classed = entry.scale != AttributeScale::quantitative;
    for (const float value : values) {
        if (std::isnan(value)) continue;
        if (!within(value, entry.minimum, entry.maximum)) return false;
        if (is_classed && (value < 0 || value >= static_cast<float>(entry.class_count) || value != std::floor(value)))
            return false;
    }
    return true;
}

bool states_hold(base::Span<const ValueState> states) {
    for (const ValueState state : states)
        if (state > ValueState::missing) return false;
    return true;
}

}  // namespace tedavis::scene
