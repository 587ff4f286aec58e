/// The compass rose: a card that turns under a fixed lubber line, with the selected heading, the bearing of the waypoint, the
/// track and the predicted turn.
///
/// Where the layout's box is high enough the rose is whole; else its lower part is cut off, so that the card keeps a readable
/// size: at least 200 degrees remain, and so does the room around the center in which the lateral deviation moves. On screens
/// where ticks of 5 degrees or labels of 30 degrees would touch, the card has ticks of 10 degrees, or labels of the four winds
/// alone. Angles on the rose are rad, clockwise from the lubber line; lengths are pixels. Pure.
#pragma once

#include <cstdint>

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

enum class RoseSide : std::uint8_t { left, right };
inline constexpr int kRoseRows = 4, kMinRoseRows = 3;

struct CompassRose {
    Rect box;      ///< all
    Rect readout;  ///< the digital heading, above the lubber line
    Rect card;     ///< the rest of the box, to which the card is cut
    Point center;
    float radius = 0;  ///< of the scale
    float text_px = 0;
    float mark_px = 0;  ///< the unit of marks on the card: a text, or less on a small rose
    bool is_whole = false;
    int rows = kRoseRows;  ///< number of rows of text that fit on either side; at least kMinRoseRows

    /// `across`: to the right of the ray, seen from the center.
    [[nodiscard]] Point at(double angle_rad, float distance, float across = 0) const noexcept;
    /// The place of a short text beside the card; `row` is less than `rows`. Beside a whole rose the last two rows are at the
    /// foot.
    [[nodiscard]] Rect side_row(RoseSide side, int row) const noexcept;
    /// The part of it, at its outer end, where a name is crossed out.
    [[nodiscard]] Rect side_cross(RoseSide side, int row) const noexcept;
};

[[nodiscard]] CompassRose make_compass_rose(const Layout& layout) noexcept;

/// Returns the angle of a true direction on the rose; NaN where the rose is magnetic and the variation is not known.
[[nodiscard]] double rose_angle_rad(const SymbologyInput& input, double true_rad) noexcept;

/// Three digits of a true direction in the rose's reference, where its variation is known.
[[nodiscard]] ShortText rose_degrees(const SymbologyInput& input, double true_rad) noexcept;

void build_rose_card(const Painter& painter, const CompassRose& rose, double heading_rad);
void build_lubber_line(const Painter& painter, const CompassRose& rose);
/// The heading's change within 6 s at the present rate of turn, along the edge, with marks at half the standard rate and at the
/// standard rate of the aircraft (3 degrees a second without an aircraft file). It ends at 4 degrees a second.
void build_turn_trend(const Painter& painter, const CompassRose& rose, const SymbologyInput& input);
/// The track, the bearing of the waypoint and the selected heading on the card. A magnetic rose without variation has none.
void build_rose_marks(const Painter& painter, const CompassRose& rose, const SymbologyInput& input);
/// Their values and the failures of these and of the turn, beside the card; an amber VAR where the variation is missing.
void build_rose_texts(const Painter& painter, const CompassRose& rose, const SymbologyInput& input);

}  // namespace tedavis::draw
