/// The plan of a database before chunks are made: lattice, levels, tolerances, vertex grid, and the units of work.
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
    /// Vertical accuracy of the sources (LE90), m; 0: unknown; nothing: unknown in a build, as the database states in a check.
    std::optional<double> le90_m;
    std::uint32_t threads = 0;  ///< 0: as many as the machine has, at most kMaxThreads
    std::string identity;       ///< identity of the sources: an interrupted build is continued only if it is equal
    BuildProgress progress;
    /// Time between records of the journal: the work that a power failure may lose.
    std::chrono::milliseconds between_records{15000};
};

/// Each thread needs the memory of a unit; with more threads the build would need more than 512 MiB.
inline constexpr std::uint32_t kMaxThreads = 6;

/// A unit is the domain of one chunk of this level; one thread works on it, with its posts in memory.
inline constexpr std::uint32_t kUnitLevel = 5;
/// Meshes up to this level are made from all posts; higher ones from the vertices of the meshes this many levels below, whose
/// tolerance is 16 times as fine, and above the units also from posts spread over the chunk.
inline constexpr std::uint32_t kLevelsBelow = 3;
inline constexpr std::uint32_t kUnitCells = terrain::kChunkCells << kUnitLevel;

struct BuildPlan {
    terrain::FileHeader header{};  ///< without counts, heights, places and checksums
    terrain::Lattice lattice;
    PostGrid source;
    std::uint32_t source_columns = 0;    ///< columns of the source that are used, without a closing column of its own
    std::uint32_t first_source_row = 0;  ///< row of the lattice that is the source's first row
    UndulationGrid undulation;
    double cell_m = 0;            ///< larger side of the largest cell
    double half_relief_m = 5000;  ///< half the range of heights; until they are known, of those that a raster may have

    [[nodiscard]] std::uint32_t levels() const { return header.levels; }
    [[nodiscard]] std::uint32_t unit_columns() const;
    [[nodiscard]] std::uint32_t unit_rows() const;
    [[nodiscard]] std::uint32_t unit_count() const { return unit_columns() * unit_rows(); }
    [[nodiscard]] bool has_north_pole() const { return (header.lattice_flags & terrain::kLatticeNorthPole) != 0; }
    [[nodiscard]] bool has_south_pole() const { return (header.lattice_flags & terrain::kLatticeSouthPole) != 0; }
    [[nodiscard]] bool is_pole_row(std::uint32_t j) const {
        return (j == 0 && has_north_pole()) || (j == header.rows - 1 && has_south_pole());
    }

    /// The tolerance of meshes of a level in a row of chunks: that of the level, reduced where meridians converge.
    [[nodiscard]] double tolerance_m(std::uint32_t level, std::uint32_t chunk_row) const;
    /// Sets the range of heights above MSL; to be called when all posts have been read, before any chunk is made.
    void know_heights(double lowest_msl_m, double highest_msl_m);
    /// Upper bound of the distance of a vertex from its chunk's centre along any ECEF axis.
    [[nodiscard]] double farthest_vertex_m(std::uint32_t level) const;
    /// Step of the grid to which positions of vertices are rounded: a power of two, so that every chunk represents a shared
    /// vertex exactly in a float.
    [[nodiscard]] double quantum_m(std::uint32_t level) const;
};

/// Makes a plan. `finer_levels` levels are left free for insets. Throws UserError where the grid cannot be a lattice.
[[nodiscard]] BuildPlan make_build_plan(const PostGrid& grid, const BuildOptions& options, std::uint32_t finer_levels = 0);

/// Returns the plan of posts 2^finer_levels times as dense, of which every 2^finer_levels-th is a post of `plan`. Not for
/// lattices round the Earth or with a pole.
[[nodiscard]] BuildPlan make_finer_plan(const BuildPlan& plan, std::uint32_t finer_levels);

}  // namespace tedavis::host_sim
