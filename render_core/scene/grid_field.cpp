#include "render_core/scene/grid_field.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::scene {
namespace {

constexpr double kOnPost = 1e-9;  // of a step: angles that come from degrees and back

/// Between posts 0 .. count - 1 a step apart.
AxisPlace between(double posts, std::uint32_t count) {
    const double last = count - 1.0;
    if (!(posts >= -kOnPost && posts <= last + kOnPost)) return {};
    const double clamped = std::clamp(posts, 0.0, last);
    const auto first = static_cast<std::uint32_t>(clamped);
    double fraction = clamped - first;
    if (fraction < kOnPost) fraction = 0;
    return {first, std::min(first + 1, count - 1), fraction, true};
}

/// Among ascending values.
template <class T>
AxisPlace among(base::Span<const T> values, double value) {
    const auto last = static_cast<std::uint32_t>(values.size() - 1);
    if (!(value >= static_cast<double>(values[0]) && value <= static_cast<double>(values[last]))) return {};
    const T* const after =
        std::upper_bound(values.begin(), values.end(), value, [](double a, T b) { return a < static_cast<double>(b); });
    const auto second = std::min(static_cast<std::uint32_t>(after - values.begin()), last);
    if (second == 0) return {0, 0, 0, true};
    const double low = static_cast<double>(values[second - 1]), high = static_cast<double>(values[second]);
    return {second - 1, second, (value - low) / (high - low), true};
}

std::uint32_t nearest_of(const AxisPlace& axis) { return axis.fraction < 0.5 ? axis.first : axis.second; }

}  // namespace

GridField::GridField(const Layer& layer, const Attribute& attribute) : layer_(&layer), attribute_(&attribute) {
    const GridShape& g = layer.entry->grid;
    is_closed_ = g.step_lon_rad * g.columns >= 2 * base::kPi - kOnPost;
}

AxisPlace GridField::column_at(double longitude_rad) const {
    const GridShape& g = layer_->entry->grid;
    // East of the first column, 0 .. 2 pi, so that no grid ends at the antimeridian.
    double east_rad = earth::wrap_heading(longitude_rad - g.west_rad);
    if (2 * base::kPi - east_rad < kOnPost * g.step_lon_rad) east_rad = 0;
    const double posts = east_rad / g.step_lon_rad;
    if (!is_closed_ || posts <= g.columns - 1.0) return between(posts, g.columns);
    return {g.columns - 1, 0, posts - (g.columns - 1.0), true};
}

AxisPlace GridField::row_at(double latitude_rad) const {
    const GridShape& g = layer_->entry->grid;
    return between((g.north_rad - latitude_rad) / g.step_lat_rad, g.rows);
}

AxisPlace GridField::level_at(double height_m) const {
    if (layer_->levels_m.empty()) return {0, 0, 0, true};
    return among(layer_->levels_m, height_m);
}

AxisPlace GridField::time_at(std::int64_t time_ns) const {
    const base::Span<const std::int64_t>& times = layer_->times_ns;
    if (times.empty()) return {0, 0, 0, true};
    const std::int64_t held = std::clamp(time_ns, times[0], times[times.size() - 1]);
    // Relative to the first, where doubles are exact to the nanosecond for a hundred days.
    const std::int64_t* const after = std::upper_bound(times.begin(), times.end(), held);
    const auto last = static_cast<std::uint32_t>(times.size() - 1);
    const auto second = std::min(static_cast<std::uint32_t>(after - times.begin()), last);
    if (second == 0) return {0, 0, 0, true};
    const auto part = static_cast<double>(held - times[second - 1]),
               whole = static_cast<double>(times[second] - times[second - 1]);
    return {second - 1, second, part / whole, true};
}

base::Duration GridField::age(std::int64_t time_ns) const {
    const base::Span<const std::int64_t>& times = layer_->times_ns;
    if (!times.empty()) {
        const std::int64_t held = std::clamp(time_ns, times[0], times[times.size() - 1]);
        return base::Time{time_ns} - base::Time{held};
    }
    const std::int64_t data_time_ns = layer_->entry->data_time_ns;
    return data_time_ns == kNoTime ? base::Duration{} : base::Time{time_ns} - base::Time{data_time_ns};
}

FieldValue GridField::at(double latitude_rad, double longitude_rad, double height_m, std::int64_t time_ns) const {
    const AxisPlace axes[4] = {column_at(longitude_rad), row_at(latitude_rad), level_at(height_m), time_at(time_ns)};
    return blend(axes, age(time_ns));
}

FieldValue GridField::at_post(std::uint32_t column, std::uint32_t row, const AxisPlace& level, const AxisPlace& time,
                              base::Duration age) const {
    const AxisPlace axes[4] = {{column, column, 0, true}, {row, row, 0, true}, level, time};
    return blend(axes, age);
}

FieldValue GridField::blend(const AxisPlace (&axes)[4], base::Duration age) const {
    for (const AxisPlace& axis : axes)
        if (!axis.inside) return {};
    if (attribute_->entry->scale != AttributeScale::quantitative) return nearest(axes, age);
    FieldValue blended{0, {}, ValueState::valid};
    double level = 0;
    bool is_known = true;
    for (unsigned corner = 0; corner < 16; ++corner) {
        double weight = 1;
        std::uint32_t n[4];
        for (unsigned axis = 0; axis < 4; ++axis) {
            const bool is_second = (corner >> axis & 1u) != 0;
            weight *= is_second ? axes[axis].fraction : 1 - axes[axis].fraction;
            n[axis] = is_second ? axes[axis].second : axes[axis].first;
        }
        if (weight == 0) continue;
        const std::size_t index = index_of(n[0], n[1], n[2], n[3]);
        const ValueState state = attribute_->state(index);
        if (state == ValueState::missing) return {};
        if (state == ValueState::interpolated) blended.state = state;
        const Uncertainty uncertainty = attribute_->uncertainty(index);
        is_known = is_known && uncertainty.is_known();
        blended.value += weight * double{attribute_->values[index]};
        level += weight * uncertainty.level();
    }
    if (is_known)
        blended.uncertainty = aged(Uncertainty::from_level(level), age, double{attribute_->entry->uncertainty_growth_per_hour});
    return blended;
}

FieldValue GridField::nearest(const AxisPlace (&axes)[4], base::Duration age) const {
    const std::size_t index = index_of(nearest_of(axes[0]), nearest_of(axes[1]), nearest_of(axes[2]), nearest_of(axes[3]));
    const ValueState state = attribute_->state(index);
    if (state == ValueState::missing) return {};
    return {double{attribute_->values[index]},
            aged(attribute_->uncertainty(index), age, double{attribute_->entry->uncertainty_growth_per_hour}), state};
}

std::size_t GridField::index_of(std::uint32_t column, std::uint32_t row, std::uint32_t level, std::uint32_t time) const {
    const GridShape& g = layer_->entry->grid;
    return ((std::size_t{time} * g.levels + level) * g.rows + row) * g.columns + column;
}

}  // namespace tedavis::scene
