/// The activity mark: a ring with a hand at the right end of the strip of annunciations. The hand moves with each new position of
/// the own ship, and stands still where none comes or where the whole display stands still, which a pilot could not see
/// otherwise.
///
/// The hand's angle depends on the position's time alone, so equal inputs give equal pictures. It turns once in seven seconds.
/// With the shipped limits positions that come so rarely are lost, so two consecutive positions never give the same angle.
///
/// Pure: no GL, no clock, no heap. Thread any.
#pragma once

#include "render_core/base/time.hpp"
#include "render_core/draw/rect.hpp"
#include "render_core/draw/symbology/painter.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::draw {

inline constexpr base::Duration kActivityTurn = base::Duration::seconds(7);

/// Returns the hand's angle, clockwise from up: 0 <= angle < 2 pi.
[[nodiscard]] double activity_angle_rad(base::Time position_time) noexcept;

/// Returns the square of the mark, pixels: at the right end of the strip and within it.
[[nodiscard]] Rect activity_mark_box(const Rect& strip, float text_px) noexcept;
/// Returns the part of the strip that remains for its texts.
[[nodiscard]] Rect beside_activity_mark(const Rect& strip, float text_px) noexcept;

/// A narrower strip has no mark, only texts.
inline constexpr float kNarrowestWithActivity_px = 300;
/// False where the design does not show the phase, before the first position, and in a strip that is too narrow.
[[nodiscard]] bool shows_activity(const SymbologyInput& input, const Rect& strip) noexcept;
void build_activity_mark(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
