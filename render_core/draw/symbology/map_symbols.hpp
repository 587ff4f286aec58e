/// Symbols of the map: the own ship in the middle, pointing along the heading; a range ring of a round number of nautical
/// miles; the north arrow with the map's orientation.
///
/// In the orthographic view the symbols lie level: the ring is an ellipse round the point on the ground below the own ship, and a
/// line leads from the own ship down to this point. The ring is interrupted in magnified areas, where it would be wrong; each
/// magnified area has a sign with its scale, and a text in the corner of the map says that it is distorted. The corner also says
/// ORTHO in the orthographic view, and FLAT where the ground is drawn without relief.
///
/// Without a position a red cross replaces the symbols; with a stale position they are amber, with a text. Without a heading the
/// own ship is a disc. The symbols are drawn in the box that the layout reserves for the attitude; the ring and the line may
/// reach below the compass rose.
#pragma once

#include <string_view>

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

void build_map_symbols(const Painter& painter, const SymbologyInput& input);

struct RangeRing {
    double radius_m = 0;
    std::string_view label;
};
/// Returns the largest ring whose radius is 1, 2 or 5 times a power of ten nautical miles or kilometres and at most `room_px`;
/// radius 0 where none fits.
[[nodiscard]] RangeRing range_ring(double room_px, double px_per_m, base::DisplayUnits units) noexcept;

}  // namespace tedavis::draw
