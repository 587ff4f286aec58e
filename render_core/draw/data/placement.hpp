/// Where features of a scene are in space, and what colours they have.
///
/// Pure but for the ground that is asked. Bounded. Thread  the ground's.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render_core/draw/data/element_input.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/feature_values.hpp"

namespace tedavis::draw {

/// Axes at a place: unit vectors in ECEF.
struct LocalAxes {
    glm::dvec3 east{0}, north{0}, up{0};
};
[[nodiscard]] LocalAxes local_axes(double latitude_rad, double longitude_rad);
[[nodiscard]] LocalAxes local_axes(const earth::Ecef& place);

struct Placed {
    glm::dvec3 place{0};    ///< ECEF, m
    double height_m = 0;    ///< over the ellipsoid
    bool is_known = false;  ///< false: no ground is known where the place asks for it
};
/// A height in a layer's datum as one over the ellipsoid; NaN stands on the ground.
[[nodiscard]] Placed placed(const ElementInput& input, double latitude_rad, double longitude_rad, double height_m);
[[nodiscard]] Placed placed(const ElementInput& input, const scene::ScenePoint& point);
/// The same over the ground, whatever the layer's datum.
[[nodiscard]] Placed placed_over_ground(const ElementInput& input, double latitude_rad, double longitude_rad, double over_m);

/// A height over the ellipsoid as one in the layer's datum: what placed() makes a place of.
[[nodiscard]] double height_in_datum_m(const ElementInput& input, double latitude_rad, double longitude_rad, double height_m);

/// The colour of an encoding at value n of its attribute; `plain` where the element has no such encoding, the colour of missing
/// data where the layer has no such attribute, the value is missing, or a nominal palette has no such class. Beside a focus as
/// its look says (layer_foci.hpp); n then is a feature.
[[nodiscard]] design::Color encoded_color(const ElementInput& input, const design::ColorEncoding& encoding, std::size_t n);
/// How unsure the element's coloured value is; where it shows none, how unsure the layer's first attribute with an uncertainty
/// is; certain where nothing is stated.
[[nodiscard]] scene::Uncertainty encoded_uncertainty(const ElementInput& input, std::size_t n);
/// Of the uncertainty that encoded_uncertainty() gives.
[[nodiscard]] double uncertainty_growth_per_hour(const ElementInput& input);

[[nodiscard]] design::Color encoded_color(const ElementInput& input, const design::ColorEncoding& encoding,
                                          const scene::PointOfFeature& of);
/// Of what the encoding shows; of a plain colour, what encoded_uncertainty() says above.
[[nodiscard]] scene::Uncertainty encoded_uncertainty(const ElementInput& input, const design::ColorEncoding& encoding,
                                                     const scene::PointOfFeature& of);

/// How far off a point's place may be (95 %, m), level and upright: the point's attributes "position_accuracy" and
/// "height_accuracy", else what the layer states as a whole; 0: nobody knows.
struct PlaceAccuracy {
    double level_m = 0, height_m = 0;
};
[[nodiscard]] PlaceAccuracy place_accuracy(const scene::Layer& layer, const scene::PointOfFeature& of);
/// The same where what is unknown is as bad as the worst, and heights of which nothing is said are as good as places.
[[nodiscard]] PlaceAccuracy cautious_accuracy(const scene::Layer& layer, const scene::PointOfFeature& of,
                                              const PlaceAccuracy& worst);
/// The largest of these attributes over all points; 0 where no point has one.
[[nodiscard]] PlaceAccuracy worst_accuracy(const scene::Layer& layer);
/// False where it is 0 everywhere.
[[nodiscard]] bool states_accuracy(const scene::Layer& layer);

}  // namespace tedavis::draw
