/// How much of a round light is seen through a round aperture: overlaps of caps on the unit sphere (Oat and Sander 2007; the
/// exact area after Tovchigrechko and Vakser 2001).
///
/// Radii are angles 0..pi/2, distances 0..pi, in radians; areas in steradians, 0..2 pi. Equalities (caps that touch, that lie in
/// each other, that are points or half spheres) give their limits, never a NaN. Pure; any thread.
#pragma once

namespace tedavis::raytrace {

[[nodiscard]] double cap_area(double radius_rad);

/// Error below 1e-9, and below 1e-4 of the smaller cap for radii from 0.004 (the sun) on.
[[nodiscard]] double cap_overlap(double radius_a_rad, double radius_b_rad, double distance_rad);

/// The same through one smoothstep instead of three arc cosines: off by at most 17 % of the smaller cap where both are of a
/// size, by 5 % for a sun in an aperture of more than five degrees.
[[nodiscard]] double smooth_cap_overlap(double radius_a_rad, double radius_b_rad, double distance_rad);

}  // namespace tedavis::raytrace
