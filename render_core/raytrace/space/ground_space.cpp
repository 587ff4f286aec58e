#include "render_core/raytrace/space/ground_space.hpp"

#include <cmath>

#include "render_core/base/check.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::raytrace {

GroundSpace::GroundSpace(const terrain::TerrainDatabase& database, const terrain::PostRange& window, double step_m)
    : database_(&database), window_(window), step_m_(step_m) {
    TEDAVIS_CHECK(fits(database.lattice(), window) && step_m > 0);
    const terrain::FileHeader& header = database.header();
    step_lon_deg_ = header.step_lon_deg;
    step_lat_deg_ = header.step_lat_deg;
    west_deg_ = header.west_deg + step_lon_deg_ * window.i0;
    const double first_row = (header.lattice_flags & terrain::kLatticeNorthPole) != 0 ? 1 : 0;
    north_deg_ = header.north_deg - step_lat_deg_ * (window.j0 - first_row);
    half_width_deg_ = 0.5 * step_lon_deg_ * (window.i1 - window.i0);
}

GroundSpace GroundSpace::refined(std::uint32_t parts) const {
    GroundSpace finer = *this;
    finer.step_lon_deg_ /= parts;
    finer.step_lat_deg_ /= parts;
    return finer;
}

bool GroundSpace::fits(const terrain::Lattice& lattice, const terrain::PostRange& window) {
    if (window.i0 >= window.i1 || window.j0 >= window.j1 || window.i1 >= lattice.columns() || window.j1 >= lattice.rows())
        return false;
    const bool has_north_pole = (lattice.flags() & terrain::kLatticeNorthPole) != 0 && window.j0 == 0;
    const bool has_south_pole = (lattice.flags() & terrain::kLatticeSouthPole) != 0 && window.j1 == lattice.rows() - 1;
    return !lattice.is_closed() && !has_north_pole && !has_south_pole;
}

double GroundSpace::latitude_rad(double row) const { return base::radians(north_deg_ - step_lat_deg_ * row); }

glm::dvec3 GroundSpace::place(const earth::Ecef& position) const {
    const earth::Geodetic at = earth::from_ecef(position);
    // The equal of the longitude that is nearest to the middle: a window across the antimeridian is one, too.
    const double middle_deg = west_deg_ + half_width_deg_;
    const double east_deg = std::remainder(base::degrees(at.longitude_rad) - middle_deg, 360.0) + half_width_deg_;
    const earth::MslHeight height = earth::to_msl(at.height, database_->undulation(at.latitude_rad, at.longitude_rad));
    return {east_deg / step_lon_deg_, (north_deg_ - base::degrees(at.latitude_rad)) / step_lat_deg_, height.m / step_m_};
}

earth::Ecef GroundSpace::position(const glm::dvec3& place) const {
    const double latitude = latitude_rad(place.y), longitude = base::radians(west_deg_ + step_lon_deg_ * place.x);
    const earth::MslHeight height{place.z * step_m_};
    return earth::to_ecef({latitude, longitude, earth::to_ellipsoid(height, database_->undulation(latitude, longitude))});
}

WorldRay GroundSpace::world_ray(const glm::dvec3& origin, const glm::dvec3& direction) const {
    // So far to both sides that it neither bends nor is lost in roundings.
    constexpr double kNear_m = 20;
    const double row = origin.y;
    const double length = glm::length(direction * glm::dvec3(column_m(row), row_m(row), step_m_));
    const double share = kNear_m / std::fmax(length, 1e-30);
    const glm::dvec3 way = position(origin + share * direction) - position(origin - share * direction);
    WorldRay ray;
    ray.origin = position(origin);
    ray.metres_of_t = glm::length(way) / (2 * share);
    ray.direction = way / glm::length(way);
    return ray;
}

double GroundSpace::column_m(double row) const {
    const double latitude = latitude_rad(row);
    return base::radians(step_lon_deg_) * earth::prime_vertical_radius_m(latitude) * std::cos(latitude);
}

double GroundSpace::row_m(double row) const { return base::radians(step_lat_deg_) * earth::meridian_radius_m(latitude_rad(row)); }

}  // namespace tedavis::raytrace
