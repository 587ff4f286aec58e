/// Compares the program's own geodesy (render_core/earth/wgs84.hpp) with GeographicLib's at every start: a build or a processor
/// that computes wrongly must show nothing.
///
/// Thread  any. Memory  none. Failure  a failed check in the report.
#pragma once

#include "render_core/earth/wgs84.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

/// The conversions that are compared; tests put others in their place.
struct OwnGeodesy {
    earth::Ecef (*to_ecef)(const earth::Geodetic&) noexcept = &earth::to_ecef;
    earth::Geodetic (*from_ecef)(const earth::Ecef&) noexcept = &earth::from_ecef;
    double (*surface_distance_m)(const earth::Geodetic&, const earth::Geodetic&) noexcept = &earth::surface_distance_m;
};

/// Adds the checks "geodetic_to_ecef", "ecef_to_geodetic" and "surface_distance": the greatest differences over 117 places from
/// pole to pole, on both sides of the antimeridian, from 430 m below the ellipsoid to 20 km above it.
void check_geodesy(SelfTestReport& report, const OwnGeodesy& own = {}) noexcept;

}  // namespace tedavis::target
