/// What the attributes of a layer say of one feature or one of its points. Pure functions; any thread.
#pragma once

#include <glm/vec2.hpp>
#include <string_view>

#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

/// A point of a line or an area: attributes of features have values by the one number, those of points by the other.
struct PointOfFeature {
    std::uint32_t feature = 0;
    std::uint32_t point = 0;  ///< of the layer's
};
/// The number by which an attribute (null: there is none) has the point's value.
[[nodiscard]] std::size_t value_number(const Attribute* attribute, const PointOfFeature& of);

/// Value n of an attribute; NaN where there is none.
[[nodiscard]] double value_or_nan(const Layer& layer, std::string_view attribute, std::size_t n);
[[nodiscard]] double value_or_nan(const Layer& layer, std::string_view attribute, const PointOfFeature& of);

/// Metres east and north that a feature with attributes "speed" (m/s) and "toward" (rad) has gone from the data's time to
/// `time_ns`; 0 where `has_date` is false, or the layer does not state its time.
[[nodiscard]] glm::dvec2 drift_m(const Layer& layer, std::uint32_t feature, std::int64_t time_ns, bool has_date);

}  // namespace tedavis::scene
