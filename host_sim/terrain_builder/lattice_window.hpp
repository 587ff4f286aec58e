/// A rectangle of posts of the lattice in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/surface_error.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

/// It may extend beyond the lattice: a lattice round the Earth is continued, others have posts of class `outside` there.
struct LatticeWindow {
    std::int64_t i0 = 0, j0 = 0;  ///< lattice coordinates of its first post
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> height_m;   ///< above MSL; filled where void
    std::vector<float> surface_m;  ///< above the ellipsoid
    std::vector<terrain::PostClass> post_class;

    [[nodiscard]] std::size_t at(std::int64_t i, std::int64_t j) const {
        return static_cast<std::size_t>(j - j0) * columns + static_cast<std::size_t>(i - i0);
    }
    [[nodiscard]] bool holds(std::int64_t i, std::int64_t j) const {
        return i >= i0 && j >= j0 && i < i0 + columns && j < j0 + rows;
    }
    /// Neither outside nor unknown.
    [[nodiscard]] bool is_valid(std::int64_t i, std::int64_t j) const {
        return holds(i, j) && post_class[at(i, j)] <= terrain::PostClass::sea;
    }
    [[nodiscard]] PostWindowView view() const { return {i0, j0, columns, rows, surface_m.data(), post_class.data()}; }
};

}  // namespace tedavis::host_sim
