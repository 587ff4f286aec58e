/// What stands on the map: the own ship in its middle, pointing along the heading; a ring of a round number of nautical miles
/// round it; the arrow to the north with what the map is turned to.
///
/// In the orthographic view they lie level: the ring is an ellipse round the own ship's place on the ground, to which a line
/// leads down. It leaves out what lies in places that are shown larger: there it would be elsewhere on the ground. Those have
/// signs with their scale, and the corner says so. The corner says ORTHO, and FLAT where the ground is drawn without its relief.
///
/// Without a position there is a red cross in their place; a stale one is amber and says so. Without a heading the own ship is a
/// disc that points nowhere. In the layout's box of the attitude.
#pragma once

#include <string_view>

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

void build_map_symbols(const Painter& painter, const SymbologyInput& input);

struct RangeRing {
    double radius_m = 0;
    std::string_view label;
};
/// The largest ring of 1, 2 or 5 times a power of ten nautical miles within `room_px`; radius 0 where none fits.
[[nodiscard]] RangeRing range_ring(double room_px, double px_per_m) noexcept;

}  // namespace tedavis::draw
