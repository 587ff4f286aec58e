/// The distance between two places along the surface of the Earth (render_core/earth/wgs84.hpp), a setting with one level.
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_surface_distance_knob(const KnobGround& ground);

/// The knob's reference: the length of the geodesic, m, in long double (T. Vincenty, Direct and inverse solutions of geodesics on
/// the ellipsoid with application of nested equations, Survey Review 23, 1975). Not for places that are almost opposite.
[[nodiscard]] double distance_by_vincenty_m(const earth::Geodetic& from, const earth::Geodetic& to);

}  // namespace tedavis::host_sim
