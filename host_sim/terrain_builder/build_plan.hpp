/// What is known of a database before chunks are made: lattice, levels, tolerances, vertex grid, and the units of work.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "host_sim/terrain_builder/post_reader.hpp"
#include "host_sim/terrain_builder/undulation_grid.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

/// Called with a stage's name and the work done of all stages, in any unit; may throw to stop.
using BuildProgress = std::function<void(std::string_view stage, std::uint64_t done, std::uint64_t total)>;

struct BuildOptions {
    /// Vertical accuracy of the sources, 0 unknown; without one, unknown in a build and what is stated in a check.
    std::optional<double> le90_m;
    std::uint32_t threads = 0;  ///< 0: as many as the machine has, at most kMaxThreads
    std::string identity;       ///< of the sources: a build goes on only where it is the same
    BuildProgress progress;
    std::chrono::milliseconds between_records{15000};  ///< how much work a power loss may cost
};

/// Each needs memory for a unit; with more the build would leave its 512 MiB.
inline constexpr std::uint32_t kMaxThreads = 6;

/// A unit is the domain of one chunk of this level: what one thread works on, with its posts in memory.
inline constexpr std::uint32_t kUnitLevel = 5;
/// Meshes up to this level are made from all posts, those above from the vertices of the meshes so many levels below, whose
/// tolerance is 16 times as fine; above the units also from posts spread over the chunk.
inline constexpr std::uint32_t kLevelsBelow = 3;
inline constexpr std::uint32_t kUnitCells = terrain::kChunkCells << kUnitLevel;

struct BuildPlan {
    terrain::FileHeader header{};  ///< without counts, heights, places and checksums
    terrain::Lattice lattice;
    PostGrid source;
    std::uint32_t source_columns = 0;    ///< of the source that are taken; a closing column of its own is not
    std::uint32_t first_source_row = 0;  ///< the lattice's row that is the source's first
    UndulationGrid undulation;
    double cell_m = 0;            ///< larger side of the largest cell
    double half_relief_m = 5000;  ///< half the range of heights: of those that a raster may hold, until they are known

    [[nodiscard]] std::uint32_t levels() const { return header.levels; }
    [[nodiscard]] std::uint32_t unit_columns() const;
    [[nodiscard]] std::uint32_t unit_rows() const;
    [[nodiscard]] std::uint32_t unit_count() const { return unit_columns() * unit_rows(); }
    [[nodiscard]] bool has_north_pole() const { return (header.lattice_flags & terrain::kLatticeNorthPole) != 0; }
    [[nodiscard]] bool has_south_pole() const { return (header.lattice_flags & terrain::kLatticeSouthPole) != 0; }
    [[nodiscard]] bool is_pole_row(std::uint32_t j) const {
        return (j == 0 && has_north_pole()) || (j == header.rows - 1 && has_south_pole());
    }

    /// The error that meshes of a level aim at in a row of chunks: the level's, less where meridians run together.
    [[nodiscard]] double tolerance_m(std::uint32_t level, std::uint32_t chunk_row) const;
    /// When the posts have been read and before anything is made of them. Above MSL.
    void know_heights(double lowest_msl_m, double highest_msl_m);
    /// No vertex of a chunk of the level lies farther from its centre along any ECEF axis.
    [[nodiscard]] double farthest_vertex_m(std::uint32_t level) const;
    /// The grid that positions of vertices are rounded to: a power of two, so that every chunk can hold a shared vertex
    /// exactly in a float.
    [[nodiscard]] double quantum_m(std::uint32_t level) const;
};

/// Throws UserError where the grid cannot be a lattice. `finer_levels` are left free for insets.
[[nodiscard]] BuildPlan make_build_plan(const PostGrid& grid, const BuildOptions& options, std::uint32_t finer_levels = 0);

/// The plan of posts 2^finer_levels times as dense, whose every 2^finer_levels-th post is one of the plan's. Not for lattices
/// round the Earth or with a pole.
[[nodiscard]] BuildPlan make_finer_plan(const BuildPlan& plan, std::uint32_t finer_levels);

}  // namespace tedavis::host_sim
