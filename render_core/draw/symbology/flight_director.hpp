/// The flight director and the flight-path reference, over the ladder.
///
/// The director is a pair of crossing bars about the aircraft symbol. The level bar is above the symbol by the commanded change
/// of pitch; the upright bar is to the right by kBarTexts_per_rad times the commanded change of bank to the right. Both are at
/// most kMaxBarTexts away from the symbol. Unlike the flight-path vector the director has neither circle nor wings. The reference
/// is a pair of dashes on both sides of the ladder at the selected glide path, with its angle: while the path is flown, the
/// flight-path vector lies between them.
#pragma once

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

inline constexpr float kBarTexts_per_rad = 10;
inline constexpr float kMaxBarTexts = 4;

void build_flight_director(const Painter& painter, const SymbologyInput& input);
void build_path_reference(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
