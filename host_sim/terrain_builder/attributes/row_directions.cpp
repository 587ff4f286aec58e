#include "host_sim/terrain_builder/attributes/row_directions.hpp"

#include <cmath>

namespace tedavis::host_sim {
namespace {

using terrain::kHorizonDirection;
using terrain::kHorizonDirections;
using terrain::LatticeDirection;

int floor_half(int value) { return (value - (value & 1)) / 2; }

SamplePlace sample_place(LatticeDirection direction, int s, std::size_t stride) {
    const int east2 = s * direction.east2, south2 = -s * direction.north2;
    SamplePlace place;
    place.plane = (south2 & 1) != 0 ? half_south : (east2 & 1) != 0 ? half_east : at_post;
    place.offset = floor_half(south2) * static_cast<std::ptrdiff_t>(stride) + floor_half(east2);
    return place;
}

double angle_between(LatticeDirection a, LatticeDirection b, double east_m, double north_m) {
    const double ae = a.east2 * east_m, an = a.north2 * north_m, be = b.east2 * east_m, bn = b.north2 * north_m;
    return std::abs(std::atan2(ae * bn - an * be, ae * be + an * bn));
}

RowDirection row_direction(std::size_t k, double east_m, double north_m) {
    const LatticeDirection here = kHorizonDirection[k], next = kHorizonDirection[(k + 1) % kHorizonDirections],
                           last = kHorizonDirection[(k + kHorizonDirections - 1) % kHorizonDirections];
    const double e = 0.5 * here.east2 * east_m, n = 0.5 * here.north2 * north_m, step_m = std::sqrt(e * e + n * n);
    RowDirection direction;
    direction.east = static_cast<float>(e / step_m);
    direction.north = static_cast<float>(n / step_m);
    const double sector = angle_between(last, here, east_m, north_m) + angle_between(here, next, east_m, north_m);
    direction.weight = static_cast<float>(sector / (4 * base::kPi));
    for (int s = 1; s <= kHorizonReach; ++s) {
        const auto index = static_cast<std::size_t>(s);
        direction.per_m[index] = static_cast<float>(1 / (s * step_m));
        direction.drop[index] = static_cast<float>(s * step_m / (2 * kHorizonEarthRadius_m));
    }
    return direction;
}

}  // namespace

std::array<SamplePlaces, kHorizonDirections> sample_places(std::size_t stride) {
    std::array<SamplePlaces, kHorizonDirections> places;
    for (std::size_t k = 0; k < kHorizonDirections; ++k)
        for (int s = 1; s <= kHorizonReach; ++s)
            places[k][static_cast<std::size_t>(s)] = sample_place(kHorizonDirection[k], s, stride);
    return places;
}

std::array<RowDirection, kHorizonDirections> row_directions(double east_m, double north_m) {
    std::array<RowDirection, kHorizonDirections> directions;
    for (std::size_t k = 0; k < kHorizonDirections; ++k) directions[k] = row_direction(k, east_m, north_m);
    return directions;
}

}  // namespace tedavis::host_sim
