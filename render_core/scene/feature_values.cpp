#include "render_core/scene/feature_values.hpp"

#include <cmath>
#include <limits>

namespace tedavis::scene {

std::size_t value_number(const Attribute* attribute, const PointOfFeature& of) {
    return attribute != nullptr && attribute->entry->of == AttributeOf::point ? of.point : of.feature;
}

/// Attributes of features may be asked by points, which do not count alike.
double value_or_nan(const Layer& layer, std::string_view name, std::size_t n) {
    const Attribute* const attribute = layer.find(name);
    const bool has_value = attribute != nullptr && n < attribute->values.size();
    return has_value ? static_cast<double>(attribute->values[n]) : std::numeric_limits<double>::quiet_NaN();
}

double value_or_nan(const Layer& layer, std::string_view attribute, const PointOfFeature& of) {
    return value_or_nan(layer, attribute, value_number(layer.find(attribute), of));
}

glm::dvec2 drift_m(const Layer& layer, std::uint32_t feature, std::int64_t time_ns, bool has_date) {
    const double speed = value_or_nan(layer, "speed", feature), toward = value_or_nan(layer, "toward", feature);
    const std::int64_t since = layer.entry->data_time_ns;
    if (!has_date || since == kNoTime || !std::isfinite(speed) || !std::isfinite(toward)) return glm::dvec2(0);
    const double gone_m = speed * 1e-9 * static_cast<double>(time_ns - since);
    return {gone_m * std::sin(toward), gone_m * std::cos(toward)};
}

}  // namespace tedavis::scene
