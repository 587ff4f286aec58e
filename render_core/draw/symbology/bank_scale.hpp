/// The scale of bank above the ladder: ticks at 10, 20, 30, 45 and 60 degrees, the sky pointer that turns against them, and the
/// slip indicator below the pointer.
///
/// The slip indicator moves as the ball of a slip indicator does, away from the acceleration that is felt: its own width for
/// kSlipWidth_mps2, at most kMaxSlipWidths. A coordinated turn leaves it below the pointer.
#pragma once

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

inline constexpr double kSlipWidth_mps2 = 0.05 * base::kStandardGravity;
inline constexpr double kMaxSlipWidths = 2;

/// Returns the radius of the scale, pixels; its centre is the middle of the screen.
[[nodiscard]] float bank_scale_radius(const Layout& layout) noexcept;
/// Returns `from` moved by `along` in a unit direction and by `across` to its right on the screen.
[[nodiscard]] Point along_and_across(Point from, Point direction, float along, float across) noexcept;

void build_bank_scale(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
