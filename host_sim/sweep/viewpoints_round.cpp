#include "host_sim/sweep/viewpoints_round.hpp"

#include <cmath>
#include <cstdio>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

/// Where a step in the horizontal plane of the place leads, on the ellipsoid.
earth::Geodetic stepped_from(const earth::Geodetic& place, double bearing_rad, double distance_m) {
    const glm::dmat3 frame = earth::north_east_down(place.latitude_rad, place.longitude_rad);
    const earth::Geodetic ground{place.latitude_rad, place.longitude_rad, {}};
    const glm::dvec3 step = frame[0] * std::cos(bearing_rad) + frame[1] * std::sin(bearing_rad);
    return earth::from_ecef(earth::to_ecef(ground) + step * distance_m);
}

void look_at(const earth::Geodetic& place, Viewpoint& viewpoint) {
    const glm::dmat3 frame = earth::north_east_down(viewpoint.position.latitude_rad, viewpoint.position.longitude_rad);
    const glm::dvec3 way = glm::transpose(frame) * (earth::to_ecef(place) - earth::to_ecef(viewpoint.position));
    viewpoint.pose.heading_deg = base::degrees(earth::wrap_heading(std::atan2(way.y, way.x)));
    viewpoint.pose.pitch_deg = base::degrees(std::atan2(-way.z, std::hypot(way.x, way.y)));
}

std::string viewpoint_name(const Viewpoint& viewpoint) {
    char name[64];
    std::snprintf(name, sizeof name, "h%.0f_d%.0f_b%03.0f", viewpoint.height_m, viewpoint.distance_m, viewpoint.bearing_deg);
    return name;
}

Viewpoint viewpoint_at(const earth::Geodetic& place, const GeoidBelowPlace& geoid, Viewpoint viewpoint) {
    viewpoint.position = stepped_from(place, base::radians(viewpoint.bearing_deg), viewpoint.distance_m);
    const double latitude_rad = viewpoint.position.latitude_rad, longitude_rad = viewpoint.position.longitude_rad;
    const earth::MslHeight place_msl = earth::to_msl(place.height, geoid(place.latitude_rad, place.longitude_rad));
    const earth::MslHeight msl{place_msl.m + viewpoint.height_m};
    viewpoint.position.height = earth::to_ellipsoid(msl, geoid(latitude_rad, longitude_rad));
    viewpoint.pose.latitude_deg = base::degrees(latitude_rad);
    viewpoint.pose.longitude_deg = base::degrees(longitude_rad);
    viewpoint.pose.altitude_msl_m = msl.m;
    look_at(place, viewpoint);
    viewpoint.name = viewpoint_name(viewpoint);
    return viewpoint;
}

}  // namespace

std::vector<Viewpoint> viewpoints_round(const earth::Geodetic& place, const GeoidBelowPlace& geoid, const SweepRings& rings) {
    std::vector<Viewpoint> viewpoints;
    for (const double height_m : rings.heights_m)
        for (const double distance_m : rings.distances_m)
            for (std::size_t n = 0; n < rings.bearings; ++n) {
                Viewpoint viewpoint;
                viewpoint.bearing_deg = 360 * static_cast<double>(n) / static_cast<double>(rings.bearings);
                viewpoint.distance_m = distance_m;
                viewpoint.height_m = height_m;
                viewpoints.push_back(viewpoint_at(place, geoid, viewpoint));
            }
    return viewpoints;
}

}  // namespace tedavis::host_sim
