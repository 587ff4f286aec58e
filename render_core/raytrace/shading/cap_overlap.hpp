/// The visible part of a round light through a round aperture: overlaps of caps on the unit sphere (Oat and Sander 2007; the
/// exact area after Tovchigrechko and Vakser 2001).
///
/// Radii are angles 0..pi/2, distances 0..pi, in radians; areas in steradians, 0..2 pi. Degenerate cases (caps that touch,
/// contain each other, are points or half spheres) give their limits, never NaN. Pure; any thread.
#pragma once

namespace tedavis::raytrace {

[[nodiscard]] double cap_area(double radius_rad);

/// Returns the area of the overlap; error below 1e-9, and below 1e-4 of the smaller cap for radii from 0.004 (the sun) on.
[[nodiscard]] double cap_overlap(double radius_a_rad, double radius_b_rad, double distance_rad);

/// The same with one smoothstep instead of three arc cosines. The error is at most 17 % of the smaller cap where both have
/// similar sizes, 5 % for the sun in an aperture of more than five degrees.
[[nodiscard]] double smooth_cap_overlap(double radius_a_rad, double radius_b_rad, double distance_rad);

}  // namespace tedavis::raytrace
