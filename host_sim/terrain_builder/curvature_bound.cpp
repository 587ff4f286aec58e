#include "host_sim/terrain_builder/curvature_bound.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

// Upper bounds over all latitudes, for heights up to 10 km.
constexpr double kRadius_m = 6410000;      // N + h and M + h
constexpr double kRadiusChange_m = 65500;  // dM/dφ

struct LatitudeRange {
    double extent = 0, cosine = 1, sine = 0;  // largest values in the range
};

LatitudeRange latitude_range(const terrain::Lattice& lattice, std::uint32_t j0, std::uint32_t j1) {
    const double north = lattice.latitude_rad(j0), south = lattice.latitude_rad(j1);
    const bool spans_equator = north > 0 && south < 0;
    return {north - south, spans_equator ? 1.0 : std::max(std::cos(north), std::cos(south)),
            std::max(std::abs(std::sin(north)), std::abs(std::sin(south)))};
}

bool is_pole(const terrain::Lattice& lattice, std::uint32_t j) { return std::abs(lattice.latitude_rad(j)) >= base::kPi / 2; }

/// Between a pole and its ring: meridians run together, and along each of them heights are linear in the triangle and in the
/// true surface.
bool is_wedge(const terrain::Lattice& lattice, std::uint32_t j0, std::uint32_t j1) {
    return j1 == j0 + 1 && (is_pole(lattice, j0) || is_pole(lattice, j1));
}

/// A row beside a pole lies elsewhere than even spacing would have it, and what is linear over the lattice is not so in space
/// between the columns of the first ring.
double pole_shift_m(const terrain::Lattice& lattice, std::uint32_t j0, std::uint32_t j1) {
    const std::uint32_t last = lattice.rows() - 1;
    const auto latitude = [&lattice](std::uint32_t j) { return lattice.latitude_rad(j); };
    const auto shift_at = [&](std::uint32_t pole, std::uint32_t ring, std::uint32_t next) {
        if (!is_pole(lattice, pole)) return 0.0;
        const double gap = std::abs(latitude(pole) - latitude(ring)), step = std::abs(latitude(ring) - latitude(next));
        const double column = std::abs(lattice.longitude_rad(1) - lattice.longitude_rad(0)) * std::cos(latitude(ring));
        return kRadius_m * (std::abs(gap - step) + column);
    };
    double shift_m = 0;
    if (j0 == 0 && last >= 2) shift_m += shift_at(0, 1, 2);
    if (j1 == last && last >= 2) shift_m += shift_at(last, last - 1, last - 2);
    return shift_m;
}

}  // namespace

CurvatureBound curvature_bound(const terrain::Lattice& lattice, std::uint32_t columns, std::uint32_t j0, std::uint32_t j1,
                               double rise_m) {
    const LatitudeRange range = latitude_range(lattice, j0, j1);
    const double east = std::abs(lattice.longitude_rad(1) - lattice.longitude_rad(0)) * columns, north = range.extent;
    const double down = 0.125 * kRadius_m * (east * east * range.cosine * range.cosine + north * north);
    const bool wedge = is_wedge(lattice, j0, j1);
    const double crosswise = wedge ? 0 : kRadius_m * range.sine * east * north;
    const double eastwards = 0.25 * (crosswise + range.cosine * east * rise_m);
    const double northwards =
        0.125 * (kRadius_m * range.cosine * range.sine * east * east + kRadiusChange_m * north * north) + 0.25 * north * rise_m;
    const double sideways = std::hypot(eastwards, northwards);
    const double turn = std::min(1.0, east * range.cosine + north);
    CurvatureBound bound;
    bound.shift_m = sideways + down * turn + (wedge ? 0 : pole_shift_m(lattice, j0, j1));
    bound.down_m = down + sideways * turn;
    bound.up_m = sideways * turn + bound.shift_m * bound.shift_m / (2 * earth::kMinCurvatureRadius_m);
    return bound;
}

}  // namespace tedavis::host_sim
