/// A lattice of posts over a square round a place, its sides along the meridian and the parallel.
#pragma once

#include <cstdint>

#include "host_sim/scenario/local_plane.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::host_sim {

class SquareGrid {
public:
    /// `reach_m`: half of a side; `posts`: along a side, two or more.
    SquareGrid(double reach_m, std::uint32_t posts) : reach_m_(reach_m), posts_(posts) {}

    /// Columns from the west, rows from the north.
    [[nodiscard]] double east_m(std::uint32_t column) const { return column * step_m() - reach_m_; }
    [[nodiscard]] double north_m(std::uint32_t row) const { return reach_m_ - row * step_m(); }
    [[nodiscard]] scene::GridShape shape(const LocalPlane& plane, std::uint32_t levels, std::uint32_t times) const {
        const PlanePlace corner = plane.at(-reach_m_, reach_m_);
        return {corner.longitude_rad,
                corner.latitude_rad,
                step_m() * plane.longitude_per_m(),
                step_m() * plane.latitude_per_m(),
                posts_,
                posts_,
                levels,
                times};
    }

private:
    [[nodiscard]] double step_m() const { return 2 * reach_m_ / (posts_ - 1); }

    double reach_m_;
    std::uint32_t posts_;
};

}  // namespace tedavis::host_sim
