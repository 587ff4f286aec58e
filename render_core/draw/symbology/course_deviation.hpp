/// The course of the navigation source on the compass rose, with the lateral deviation from it, and the vertical deviation
/// beside the altitude tape.
///
/// Green is a radio receiver (LOC1, LOC2, GS), magenta GNSS (GPS, GP); the names stand beside. A bar, or a pointer, moves along
/// two dots to either side; beyond them it stays at the end and is hollow. It lies where the course or the path is: own ship
/// right of the course, bar to the left; own ship above the path, pointer below the middle. Where the course's direction is not
/// known (not stated, failed, or no magnetic variation) the deviation's bar is upright and has no arrow.
///
/// Stale values are amber with STALE, failed ones crossed out in red. Pure.
#pragma once

#include <string_view>

#include "render_core/draw/symbology/compass_rose.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::draw {

/// Deviations of two dots. These are the customary values of displays, not a certified scaling: radio receivers have an angle,
/// GNSS a distance that depends on the phase of the flight.
struct DeviationScale {
    double lateral = 0;     ///< rad (radio) or m (GNSS); 0: the source has none
    double vertical = 0;    ///< rad (radio) or m (GNSS)
    std::string_view name;  ///< name of the scale: ENR, TERM, APR; empty where the source has only one
};
/// Localizer 2.5 and glide slope 0.7 degrees. GNSS in cruise and in an unknown phase 2 NM and 500 ft, on the ground, in take-off,
/// descent and go-around 1 NM and 500 ft, in the rest of an approach 0.3 NM and 250 ft.
[[nodiscard]] DeviationScale deviation_scale(flight::NavigationSource source, flight::FlightPhase phase) noexcept;

/// The needle with the scale and the bar, within the card.
void build_course(const Painter& painter, const CompassRose& rose, const SymbologyInput& input);
/// The course's number, the source's name and its scale, beside the card.
void build_course_texts(const Painter& painter, const CompassRose& rose, const SymbologyInput& input);
/// Two dots up and down with a diamond (radio) or a chevron (GNSS), in the layout's box `vertical_deviation`.
void build_vertical_deviation(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
