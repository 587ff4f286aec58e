/// Symbols of the map: the own ship in the middle, pointing along the heading; a range ring of a round number of nautical
/// miles; the north arrow with the map's orientation.
///
/// In the orthographic view they are level: the ring is an ellipse round the own ship's position on the ground, to which a line
/// leads down. The ring is interrupted in magnified areas, where it would be wrong; these have signs with their scale, and the
/// corner states them. The corner also says ORTHO, and FLAT where the ground is drawn without relief.
///
/// Without a position a red cross replaces them; a stale position is amber with a text. Without a heading the own ship is a
/// disc. They are drawn in the layout's box of the attitude; ring and line reach below the rose.
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
