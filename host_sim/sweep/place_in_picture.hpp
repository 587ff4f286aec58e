/// How much a place in a picture draws the eye.
#pragma once

#include "host_sim/evaluation/evaluation_views.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::host_sim {

/// Pixels from the picture's upper left corner.
struct PlaceInPicture {
    static constexpr double kMinRadius_px = 8;
    bool is_inside = false;  ///< its middle lies in the picture, before the eye; the rest is 0 otherwise
    double x_px = 0, y_px = 0, radius_px = 0;
};
/// `radius_m` is the radius of the place; at least kMinRadius_px in the picture, since a single pixel is not perceived.
[[nodiscard]] PlaceInPicture place_in_picture(const terrain::View& view, const earth::Ecef& place, double radius_m);

struct PlaceSaliency {
    double share = 0;  ///< 0..1 of all saliency
    double area = 0;   ///< 0..1 of all pixels
    /// Share of the picture's pixels that draw the eye less than the place's strongest one; 1 but for that one: it comes first.
    double rank = 0;

    /// How many times more it draws the eye than its area would have; 0 without area.
    [[nodiscard]] double times_mean() const { return area > 0 ? share / area : 0; }
};
/// `map` has a value a pixel, the place lies inside.
[[nodiscard]] PlaceSaliency place_saliency(const FloatMap& map, const PlaceInPicture& place);

}  // namespace tedavis::host_sim
