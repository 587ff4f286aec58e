/// Other aircraft as signs that face the eye: a diamond at the place, a line to where it will be in kVelocityLine_s, its name,
/// its height over or under the own ship in hundreds of feet with an arrow when it climbs or sinks, the age of the last report
/// when that is kShownAge_s old or unknown, and with the uncertainty technique "ellipsoid" a circle where it may be by now (95 %,
/// traffic_state.hpp), or a dashed rim and a question mark where nobody knows. What is stale is grey, crossed out, and shows its
/// age; traffic_state.hpp says when. `link` leads a line down to the ground.
///
/// Pure but for the ground that is asked. Bounded.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr double kVelocityLine_s = 30, kShownAge_s = 5, kShownClimb_mps = 2.54;  // 500 feet a minute
inline constexpr design::Color kStaleTraffic{150, 150, 150};
inline constexpr double kFarthestTraffic_m = 60'000;

/// The nearest first: what would cover a nearer one, and what terrain stands before, is hidden, and counted.
/// The symbology hides no diamond: it is drawn over them. Texts come after all diamonds, and stand right of theirs, left, below
/// or above, where they are clear of the symbology and of every sign; what has no such room is left out whole.
[[nodiscard]] ElementCount add_traffic_signs(BillboardSheet& sheet, const ElementInput& input);

}  // namespace tedavis::draw
