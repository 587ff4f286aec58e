/// Positions of a window's posts in ECEF, and the normals there.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/lattice_window.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

/// Sines and cosines of a window's rows and columns, computed once. Positions equal those of Lattice::position bit for bit.
class PostPlaces {
public:
    /// The window may extend over the seam of a lattice round the Earth; other columns and rows outside must not be requested.
    PostPlaces(const terrain::Lattice& lattice, std::int64_t i0, std::int64_t j0, std::uint32_t columns, std::uint32_t rows);

    [[nodiscard]] earth::Ecef at(std::int64_t i, std::int64_t j, double surface_m) const;
    /// Normal of the ellipsoid.
    [[nodiscard]] glm::dvec3 up(std::int64_t i, std::int64_t j) const;
    /// Unit normal of the full-resolution surface: central differences over valid neighbours; the ellipsoid's normal where there
    /// are none.
    [[nodiscard]] glm::dvec3 normal(const LatticeWindow& window, std::int64_t i, std::int64_t j) const;

private:
    struct Row {
        double sine, cosine, radius_m;  // of curvature in the prime vertical
        int pole;                       // 1 north, -1 south, 0 none
    };
    struct Column {
        double sine, cosine;
    };
    [[nodiscard]] const Row& row(std::int64_t j) const { return rows_[static_cast<std::size_t>(j - j0_)]; }
    [[nodiscard]] const Column& column(std::int64_t i) const { return columns_[static_cast<std::size_t>(i - i0_)]; }

    std::int64_t i0_, j0_;
    std::vector<Row> rows_;
    std::vector<Column> columns_;
};

}  // namespace tedavis::host_sim
