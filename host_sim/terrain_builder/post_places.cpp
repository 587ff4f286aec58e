#include "host_sim/terrain_builder/post_places.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

std::uint32_t inside(const terrain::Lattice& lattice, std::int64_t i) {
    const std::int64_t last = lattice.columns() - 1;
    if (i >= 0 && i <= last) return static_cast<std::uint32_t>(i);
    return static_cast<std::uint32_t>(lattice.is_closed() ? ((i % last) + last) % last : std::clamp<std::int64_t>(i, 0, last));
}

}  // namespace

PostPlaces::PostPlaces(const terrain::Lattice& lattice, std::int64_t i0, std::int64_t j0, std::uint32_t columns,
                       std::uint32_t rows)
    : i0_(i0), j0_(j0) {
    for (std::uint32_t n = 0; n < columns; ++n) {
        const double longitude = lattice.longitude_rad(inside(lattice, i0 + n));
        columns_.push_back({std::sin(longitude), std::cos(longitude)});
    }
    for (std::int64_t j = j0; j < j0 + rows; ++j) {
        const double latitude =
            lattice.latitude_rad(static_cast<std::uint32_t>(std::clamp<std::int64_t>(j, 0, lattice.rows() - 1)));
        const double sine = std::sin(latitude);
        const double radius_m = earth::kSemiMajorAxis_m / std::sqrt(1.0 - earth::kEccentricitySquared * sine * sine);
        const int pole = std::abs(latitude) < base::kPi / 2 ? 0 : latitude > 0 ? 1 : -1;
        rows_.push_back({sine, std::cos(latitude), radius_m, pole});
    }
}

earth::Ecef PostPlaces::at(std::int64_t i, std::int64_t j, double surface_m) const {
    const Row& r = row(j);
    if (r.pole != 0) return {0, 0, r.pole * (earth::kSemiMajorAxis_m * (1 - earth::kFlattening) + surface_m)};
    const Column& c = column(i);
    const double rho = (r.radius_m + surface_m) * r.cosine;
    return {rho * c.cosine, rho * c.sine, (r.radius_m * (1.0 - earth::kEccentricitySquared) + surface_m) * r.sine};
}

glm::dvec3 PostPlaces::up(std::int64_t i, std::int64_t j) const {
    const Row& r = row(j);
    if (r.pole != 0) return {0, 0, r.pole};
    return {r.cosine * column(i).cosine, r.cosine * column(i).sine, r.sine};
}

glm::dvec3 PostPlaces::normal(const LatticeWindow& w, std::int64_t i, std::int64_t j) const {
    const std::int64_t west = w.is_valid(i - 1, j) ? i - 1 : i, east = w.is_valid(i + 1, j) ? i + 1 : i;
    const std::int64_t north = w.is_valid(i, j - 1) ? j - 1 : j, south = w.is_valid(i, j + 1) ? j + 1 : j;
    if (!w.is_valid(i, j) || west == east || north == south || row(j).pole != 0) return up(i, j);
    const auto place = [&](std::int64_t a, std::int64_t b) { return at(a, b, w.surface_m[w.at(a, b)]); };
    return glm::normalize(glm::cross(place(east, j) - place(west, j), place(i, north) - place(i, south)));
}

}  // namespace tedavis::host_sim
