/// Values of a layer's attributes at one feature or at one of its points. Pure functions; any thread.
#pragma once

#include <glm/vec2.hpp>
#include <string_view>

#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

/// A point of a line or an area: values of feature attributes are found by `feature`, those of point attributes by `point`.
struct PointOfFeature {
    std::uint32_t feature = 0;
    std::uint32_t point = 0;  ///< index among the layer's points
};
/// Returns the index of the point's value in an attribute; the attribute may be null.
[[nodiscard]] std::size_t value_number(const Attribute* attribute, const PointOfFeature& of);

/// Returns value n of an attribute; NaN where there is none.
[[nodiscard]] double value_or_nan(const Layer& layer, std::string_view attribute, std::size_t n);
[[nodiscard]] double value_or_nan(const Layer& layer, std::string_view attribute, const PointOfFeature& of);

/// Returns the metres east and north by which a feature with attributes "speed" (m/s) and "toward" (rad) has moved from the
/// data's time to `time_ns`; 0 where `has_date` is false or the layer has no time.
[[nodiscard]] glm::dvec2 drift_m(const Layer& layer, std::uint32_t feature, std::int64_t time_ns, bool has_date);

}  // namespace tedavis::scene
