/// The activity mark: a ring with a hand at the right end of the strip of annunciations. The hand moves with each new position of
/// the own ship, and stands still where none comes or where the whole display stands still, which a pilot could not see
/// otherwise.
///
/// Where the hand points follows from the position's time alone, so equal inputs give equal pictures. It turns once in seven
/// seconds: with the shipped limits a position so rare is lost, so two positions in a row never look alike.
///
/// Pure: no GL, no clock, no heap. Thread any.
#pragma once

#include "render_core/base/time.hpp"
#include "render_core/draw/rect.hpp"
#include "render_core/draw/symbology/painter.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::draw {

inline constexpr base::Duration kActivityTurn = base::Duration::seconds(7);

/// Where the hand points, clockwise from up: 0 <= angle < 2 pi.
[[nodiscard]] double activity_angle_rad(base::Time position_time) noexcept;

/// Square, pixels: at the right end of the strip, as high as the strip or less.
[[nodiscard]] Rect activity_mark_box(const Rect& strip, float text_px) noexcept;
/// What is left of the strip for its texts.
[[nodiscard]] Rect beside_activity_mark(const Rect& strip, float text_px) noexcept;

/// A narrower strip has room for its words alone, and no mark.
inline constexpr float kNarrowestWithActivity_px = 300;
/// It stands beside the phase: where the design does not show that, and before the first position, there is no mark.
[[nodiscard]] bool shows_activity(const SymbologyInput& input, const Rect& strip) noexcept;
void build_activity_mark(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
