/// Icons of features: a few strokes each, distinguishable at a dozen pixels. They follow the symbols of aeronautical charts
/// (ICAO Annex 4, appendix 2) where these exist.
///
/// Thread  any. Memory  none. Failure  false when the batch has no room.
#pragma once

#include "render_core/draw/quad_batch.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

enum class Icon : std::uint8_t {
    generic,
    obstacle,
    mast,
    turbine,
    chimney,
    crane,
    pole,
    cable,
    place,
    village,
    town,
    summit,
    airport,
    traffic,
    sample,
    storm,
    no_go,
    model,
    near_traffic,
    high_obstacle,
    ghost,
    count
};

/// Returns the icon for the class of the attribute "kind" where that is an icon's name ("peak" is a summit, "aerodrome" an
/// airport), else for the layer's role; a runway's is that of its airport.
[[nodiscard]] Icon icon_of(const scene::Layer& layer, std::uint32_t feature);

/// Obstacles from this height above the ground have another icon: 1000 ft (ICAO Annex 4: "exceptionally high").
inline constexpr double kHighObstacle_m = 304.8;
/// Returns that icon for an obstacle's, unless it is a turbine or a cable, whose kind says more.
[[nodiscard]] Icon icon_by_height(Icon icon, double height_m);

/// Draws an icon over a dark rim of the same opacity. `half_px` is from its middle to its edge; `turn_rad` turns its strokes
/// about its middle, clockwise.
bool draw_icon(QuadBatch& batch, Icon icon, Point middle, float half_px, design::Color color, float turn_rad = 0);
/// Draws a dashed circle whose dashes cover `share` of it; the share stands for the certainty of a value.
bool draw_dashed_rim(QuadBatch& batch, Point middle, float radius_px, design::Color color, float share);

}  // namespace tedavis::draw
