/// The border vertices of a chunk, from the border lines.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/ground.hpp"
#include "render_core/terrain/chunk_key.hpp"

namespace tedavis::host_sim {

struct BorderPost {
    std::uint32_t i = 0, j = 0;  ///< of the lattice
    std::uint8_t top_level = 0;  ///< highest level at which it is a border vertex of any chunk
    bool stays = false;          ///< the post is also a vertex beside a coarser neighbour
};

/// Clockwise seen from above from the north-west corner.
[[nodiscard]] std::vector<BorderPost> chunk_border(const BuildPlan& plan, const LineLevels& lines, const terrain::ChunkKey& key);

/// Returns the sides, as EdgeBits, at which a coarser chunk can be a neighbour: those that are sides of the parent, too, and no
/// borders of the lattice.
[[nodiscard]] std::uint8_t sides_of_parent(const BuildPlan& plan, const terrain::ChunkKey& key);

}  // namespace tedavis::host_sim
