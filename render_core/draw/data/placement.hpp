/// Positions and colours of a scene's features.
///
/// Pure, apart from queries to the ground. Bounded. To be called on the thread that owns the ground.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render_core/draw/data/element_input.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/feature_values.hpp"

namespace tedavis::draw {

/// The local axes at a place: unit vectors in ECEF.
struct LocalAxes {
    glm::dvec3 east{0}, north{0}, up{0};
};
[[nodiscard]] LocalAxes local_axes(double latitude_rad, double longitude_rad);
[[nodiscard]] LocalAxes local_axes(const earth::Ecef& place);

struct Placed {
    glm::dvec3 place{0};    ///< ECEF, m
    double height_m = 0;    ///< over the ellipsoid
    bool is_known = false;  ///< false: the ground that the position refers to is unknown
};
/// Returns the position. `height_m` is in the layer's datum; NaN: on the ground.
[[nodiscard]] Placed placed(const ElementInput& input, double latitude_rad, double longitude_rad, double height_m);
[[nodiscard]] Placed placed(const ElementInput& input, const scene::ScenePoint& point);
/// The same for a height above the ground.
[[nodiscard]] Placed placed_over_ground(const ElementInput& input, double latitude_rad, double longitude_rad, double over_m);

/// Converts a height above the ellipsoid to the layer's datum, the inverse of placed().
[[nodiscard]] double height_in_datum_m(const ElementInput& input, double latitude_rad, double longitude_rad, double height_m);

/// Returns the colour of an encoding at value n of its attribute: `plain` where the element has no such encoding; the colour of
/// missing data where the layer has no such attribute, the value is missing, or a nominal palette has no such class. Outside a
/// focus the colour is changed as the focus's look states (layer_foci.hpp); n must then be the index of a feature.
[[nodiscard]] design::Color encoded_color(const ElementInput& input, const design::ColorEncoding& encoding, std::size_t n);
/// Returns the uncertainty of the element's coloured value; without one, that of the layer's first attribute with an uncertainty;
/// where none is stated it counts as certain.
[[nodiscard]] scene::Uncertainty encoded_uncertainty(const ElementInput& input, std::size_t n);
/// Growth of the uncertainty that encoded_uncertainty() returns.
[[nodiscard]] double uncertainty_growth_per_hour(const ElementInput& input);

[[nodiscard]] design::Color encoded_color(const ElementInput& input, const design::ColorEncoding& encoding,
                                          const scene::PointOfFeature& of);
/// The uncertainty of what an encoding shows; for a plain colour the result of the overload above.
[[nodiscard]] scene::Uncertainty encoded_uncertainty(const ElementInput& input, const design::ColorEncoding& encoding,
                                                     const scene::PointOfFeature& of);

/// Horizontal and vertical accuracy of a point (95 %, m): its attributes "position_accuracy" and "height_accuracy", else those
/// of the layer; 0: unknown.
struct PlaceAccuracy {
    double level_m = 0, height_m = 0;
};
[[nodiscard]] PlaceAccuracy place_accuracy(const scene::Layer& layer, const scene::PointOfFeature& of);
/// The same, with unknown accuracies replaced by the worst of the layer, and a missing height accuracy by the horizontal one.
[[nodiscard]] PlaceAccuracy cautious_accuracy(const scene::Layer& layer, const scene::PointOfFeature& of,
                                              const PlaceAccuracy& worst);
/// The largest of these attributes over all points; 0 where no point has one.
[[nodiscard]] PlaceAccuracy worst_accuracy(const scene::Layer& layer);
/// True where the layer states an accuracy anywhere.
[[nodiscard]] bool states_accuracy(const scene::Layer& layer);

}  // namespace tedavis::draw
