/// Measures the saliency of a place in a picture.
#pragma once

#include "host_sim/evaluation/evaluation_views.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::host_sim {

/// Pixels from the picture's upper left corner.
struct PlaceInPicture {
    static constexpr double kMinRadius_px = 8;
    bool is_inside = false;  ///< its centre lies in the picture, in front of the camera; otherwise the other members are 0
    double x_px = 0, y_px = 0, radius_px = 0;
};
/// `radius_m` is the radius of the place; at least kMinRadius_px in the picture, since a single pixel is not perceived.
[[nodiscard]] PlaceInPicture place_in_picture(const terrain::View& view, const earth::Ecef& place, double radius_m);

struct PlaceSaliency {
    double share = 0;  ///< 0..1 of all saliency
    double area = 0;   ///< 0..1 of all pixels
    /// Share of all pixels of the picture that are less salient than the most salient one of the place; at most 1 - 1 / pixels.
    double rank = 0;

    /// Ratio of its mean saliency to that of the picture; 0 without area.
    [[nodiscard]] double times_mean() const { return area > 0 ? share / area : 0; }
};
/// `map` has one value per pixel; the place must be inside.
[[nodiscard]] PlaceSaliency place_saliency(const FloatMap& map, const PlaceInPicture& place);

}  // namespace tedavis::host_sim
