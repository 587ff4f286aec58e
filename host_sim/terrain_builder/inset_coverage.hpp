/// The chunks that exist where finer rasters lie in a coarse one: a quadtree in which neighbours differ by at most one level.
///
/// The coarse raster's posts are 2^base_level posts of the database apart; its own chunks begin at that level. Over each inset
/// there are chunks down to level 0, and around it rings of chunks of every level between, at least one chunk wide. Either all
/// children of a chunk exist, or none. Posts are those of the database, the fine ones.
#pragma once

#include <cstdint>
#include <vector>

#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

/// A chunk of this level is a unit of work; at most 32 fine posts to a coarse one.
inline constexpr std::uint32_t kMaxBaseLevel = 5;

class InsetCoverage {
public:
    /// Without insets: all chunks exist, down to level 0.
    InsetCoverage() = default;
    /// `footprints` are the posts that insets cover, inside the lattice; `base_level` is 1..kMaxBaseLevel.
    InsetCoverage(const terrain::Lattice& lattice, std::uint32_t base_level, const std::vector<terrain::PostRange>& footprints);

    [[nodiscard]] std::uint32_t base_level() const { return base_level_; }
    /// For chunks of the lattice.
    [[nodiscard]] bool exists(const terrain::ChunkKey& key) const;
    [[nodiscard]] bool has_children(const terrain::ChunkKey& key) const;
    [[nodiscard]] bool is_exact(const terrain::ChunkKey& key) const { return exists(key) && !has_children(key); }

    /// Rectangles of whole chunks of the base level that contain all chunks of finer levels; they do not touch each other.
    [[nodiscard]] const std::vector<terrain::PostRange>& regions() const { return regions_; }

private:
    [[nodiscard]] bool is_refined(std::uint32_t level, const terrain::PostRange& posts) const;

    terrain::Lattice lattice_;
    std::uint32_t base_level_ = 0;
    std::vector<std::vector<terrain::PostRange>> refined_;  ///< by level: where its chunks exist, one rectangle an inset
    std::vector<terrain::PostRange> regions_;
};

}  // namespace tedavis::host_sim
