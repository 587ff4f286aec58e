/// Decides for every post of a raster down to which tolerance it is needed: the proof behind the meshes of all levels.
///
/// For each vertex of the network the error of the two triangles that it splits is measured exhaustively, at every post
/// and at every cell centre where a mesh edge can cross the true surface's diagonal; the sagitta of a flat triangle over
/// the curved Earth is added. Errors are then made nested (no child above its parent), so that "error above tolerance"
/// picks a conforming mesh for any tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "host_sim/terrain_builder/raster.hpp"
#include "render_core/terrain/rtin.hpp"

namespace tedavis::host_sim {

/// The raster padded to whole chunks of the top level. `surface_m` is above the ellipsoid, as the display draws it.
struct Lattice {
    std::int64_t columns = 0, rows = 0;  ///< posts, a multiple of the top chunk side plus one
    std::int64_t raster_columns = 0, raster_rows = 0;
    std::uint32_t levels = 1;
    double cell_m = 0;  ///< the larger side of a cell, metres
    std::vector<float> surface_m;
    std::vector<terrain::PostClass> post_class;

    [[nodiscard]] std::size_t at(std::int64_t i, std::int64_t j) const { return static_cast<std::size_t>(j * columns + i); }
};

struct SignedError {
    double above_m = 0, below_m = 0;  ///< largest drawn minus true, largest true minus drawn; both >= 0
    bool mixed = false;               ///< the triangle holds void and valid posts: it must be split
};

/// Exhaustive error of the flat triangle against the true surface inside the raster.
[[nodiscard]] SignedError measure_triangle(const Lattice& lattice, const terrain::LatticeTriangle& triangle);
/// How far a flat triangle of this hypotenuse can lie below the curved surface, metres.
[[nodiscard]] double sagitta_m(double hypotenuse_m);

inline constexpr float kAlwaysNeeded = 1e30f;
inline constexpr std::uint8_t kNeverNeeded = 0xFF;

/// The nested error of every post, metres; kAlwaysNeeded at void borders. `pulse` is called now and then and may throw to
/// stop.
[[nodiscard]] std::vector<float> measure_errors(const Lattice& lattice, const std::function<void()>& pulse = {});

/// For every post the highest level whose mesh has it (kNeverNeeded: none). Chunk corners are kept as chunk_mesh.hpp
/// requires, and border vertices are made independent of other borders.
[[nodiscard]] std::vector<std::uint8_t> assign_levels(const Lattice& lattice, const std::vector<float>& errors,
                                                      const std::array<float, 16>& tolerance_m);

}  // namespace tedavis::host_sim
