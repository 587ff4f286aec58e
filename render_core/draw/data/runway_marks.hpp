/// Markings of a runway, as rectangles in its own plane, and its numbers.
///
/// Places are metres along the runway from its first point, and to the right seen from there. Real sizes, from ICAO Annex 14,
/// Volume I, 5.2: designation of two digits, 9 m high and 3 m wide, both larger in the same proportion where the runway is wide;
/// a centre line of 30 m long stripes and 20 m gaps, 0.9 m wide; threshold stripes 30 m long and 1.8 m wide that begin 6 m from
/// the threshold, as many as the width asks for (4 for 18 m, 16 for 60 m), with a double space in the middle; aiming points by
/// the length of the runway (table 5-1).
///
/// Numbers are those of the name ("LFPG 08L/26R"), each at the end whose direction it has. Without such a name they are the true
/// directions in tens of degrees, because a scene does not state the magnetic variation.
///
/// Pure functions; any thread. Bounded: kMaxRunwayMarks; what exceeds it is left out, centre line first.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_vector.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kMaxRunwayMarks = 320;

enum class RunwayMarkKind : std::uint8_t { threshold, number, aiming_point, center_line };

struct RunwayMark {
    double from_m = 0, to_m = 0;     ///< along, ascending
    double left_m = 0, right_m = 0;  ///< across, ascending
    RunwayMarkKind kind = RunwayMarkKind::center_line;
};
using RunwayMarks = base::FixedVector<RunwayMark, kMaxRunwayMarks>;

struct RunwayNumber {
    int tens_deg = 36;  ///< 1..36
    char side = 0;      ///< 'L', 'C', 'R', or 0
};
/// The number that a pilot sees who lands over the first point, and over the last one.
using RunwayNumbers = std::array<RunwayNumber, 2>;

/// `bearing_rad`: true direction from the first point to the last one.
[[nodiscard]] RunwayNumbers runway_numbers(std::string_view name, double bearing_rad);

/// Distance of the aiming point from its threshold; 0 where the runway is too short for one.
[[nodiscard]] double aiming_point_m(double length_m);

[[nodiscard]] RunwayMarks runway_marks(double length_m, double width_m, const RunwayNumbers& numbers);

}  // namespace tedavis::draw
