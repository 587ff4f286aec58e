#include "host_sim/terrain_builder/undulation_grid.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

struct NodePlace {
    std::size_t node;
    double part;  // of the next one
};

NodePlace place_of(double steps, std::uint32_t nodes) {
    const double node = std::clamp(std::floor(steps), 0.0, nodes - 2.0);
    return {static_cast<std::size_t>(node), std::clamp(steps - node, 0.0, 1.0)};
}

double between(const UndulationGrid& grid, const NodePlace& column, const NodePlace& row) {
    const float* p = grid.undulation_m.data() + row.node * grid.columns + column.node;
    const double north = (1 - column.part) * p[0] + column.part * p[1];
    const double south = (1 - column.part) * p[grid.columns] + column.part * p[grid.columns + 1];
    return (1 - row.part) * north + row.part * south;
}

}  // namespace

UndulationGrid UndulationGrid::covering(double west_deg, double south_deg, double east_deg, double north_deg,
                                        const GeoidEgm96& geoid) {
    UndulationGrid grid;
    grid.west_deg = std::floor(west_deg / kUndulationStep_deg) * kUndulationStep_deg;
    grid.north_deg = std::ceil(north_deg / kUndulationStep_deg) * kUndulationStep_deg;
    const auto nodes = [](double extent_deg) {
        return std::max(2u, static_cast<std::uint32_t>(std::ceil(extent_deg / kUndulationStep_deg)) + 1);
    };
    grid.columns = nodes(east_deg - grid.west_deg);
    grid.rows = nodes(grid.north_deg - south_deg);
    for (std::uint32_t j = 0; j < grid.rows; ++j)
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            const double latitude = base::radians(std::max(-90.0, grid.north_deg - kUndulationStep_deg * j));
            const double longitude = base::radians(grid.west_deg + kUndulationStep_deg * i);
            grid.undulation_m.push_back(static_cast<float>(geoid.undulation(latitude, longitude).m));
        }
    return grid;
}

double UndulationGrid::at(double latitude_deg, double longitude_deg) const {
    return between(*this, place_of((longitude_deg - west_deg) / kUndulationStep_deg, columns),
                   place_of((north_deg - latitude_deg) / kUndulationStep_deg, rows));
}

void PostUndulation::row(std::int64_t i0, std::uint32_t columns, std::uint32_t j, std::vector<double>& undulation_m) const {
    undulation_m.resize(columns);
    const double latitude_rad = lattice_.latitude_rad(j);
    const NodePlace row = place_of((grid_.north_deg - base::degrees(latitude_rad)) / kUndulationStep_deg, grid_.rows);
    const bool is_pole = std::abs(latitude_rad) >= base::kPi / 2;
    const std::int64_t last = lattice_.columns() - 1;
    for (std::uint32_t n = 0; n < columns; ++n) {
        const std::int64_t i = i0 + n;
        const std::int64_t inside = i >= 0 && i <= last    ? i
                                    : lattice_.is_closed() ? (i + last) % last
                                                           : std::clamp<std::int64_t>(i, 0, last);
        // A pole has one undulation, whatever its longitude.
        const double longitude_deg = base::degrees(lattice_.longitude_rad(is_pole ? 0 : static_cast<std::uint32_t>(inside)));
        undulation_m[n] = between(grid_, place_of((longitude_deg - grid_.west_deg) / kUndulationStep_deg, grid_.columns), row);
    }
}

}  // namespace tedavis::host_sim
