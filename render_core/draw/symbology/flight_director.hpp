/// The flight director and the flight-path reference, over the ladder.
///
/// The director is a pair of crossing bars about the aircraft symbol: the level bar lies above the symbol where the nose must go
/// up, by the angle that is asked for; the upright bar lies to the right where the aircraft must bank to the right,
/// kBarTexts_per_rad. Both stop kMaxBarTexts away. Its bars, without circle or wings, tell it from the flight-path vector. The
/// reference is a pair of dashes on both sides of the ladder at the selected glide path, with its angle: flying it, the
/// flight-path vector lies between them.
#pragma once

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

inline constexpr float kBarTexts_per_rad = 10;
inline constexpr float kMaxBarTexts = 4;

void build_flight_director(const Painter& painter, const SymbologyInput& input);
void build_path_reference(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
