/// Draws other aircraft as signs that face the viewer: a diamond at the position, filled where it is proximate
/// (traffic_state.hpp) and hollow else, a line to the position in kVelocityLine_s, the name, its height over or under the own
/// ship in hundreds of feet, above the diamond or below it, with an arrow when it climbs or sinks by kShownClimb_mps or more, the
/// age of the last report when that is kShownAge_s old or unknown, and with the uncertainty technique "ellipsoid" a circle of
/// possible positions (95 %, traffic_state.hpp), or a dashed rim and a question mark where that is unknown. Stale aircraft
/// (traffic_state.hpp) are grey, crossed out, and show their age. `link` draws a line down to the ground.
///
/// Pure, apart from queries to the ground. Bounded.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr double kVelocityLine_s = 30, kShownAge_s = 5, kShownClimb_mps = 2.54;  // 500 feet a minute
inline constexpr design::Color kStaleTraffic{150, 150, 150};
inline constexpr double kFarthestTraffic_m = 60'000;

/// The nearest come first; aircraft that would cover a nearer one, or are behind terrain, are hidden and counted. The symbology
/// does not hide diamonds; it is drawn over them. Texts are placed after all diamonds, right, left, below or above theirs,
/// clear of the symbology and all signs; without such room a text is left out.
[[nodiscard]] ElementCount add_traffic_signs(BillboardSheet& sheet, const ElementInput& input);

}  // namespace tedavis::draw
