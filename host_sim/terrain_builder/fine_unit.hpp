/// One unit of the build: all chunks of levels 0 to kUnitLevel over its domain, from its posts.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/chunk_assembly.hpp"
#include "host_sim/terrain_builder/ground.hpp"
#include "host_sim/terrain_builder/inset_coverage.hpp"
#include "host_sim/terrain_builder/part_store.hpp"
#include "host_sim/terrain_builder/tdb_layout.hpp"

namespace tedavis::host_sim {

/// What all chunks are made from.
struct ChunkSources {
    const BuildPlan& plan;
    const TdbLayout& layout;
    const PostWindows& posts;
    const LineLevels& lines;
    const Steepness& slopes;
    PartStore& store;
    std::uint32_t lift = 0;  ///< of the plan's levels to those of the database
};

/// A chunk whose payload has no place of its own beforehand.
struct IrregularChunk {
    terrain::ChunkEntry entry{};  ///< its payload's offset is still open
    std::vector<std::uint8_t> payload;
};

struct FineUnit {
    std::vector<terrain::ChunkEntry> regular;  ///< payloads are in the store
    std::vector<IrregularChunk> irregular;
};

/// Bounds and offsets of irregular payloads remain to be set. Any thread.
[[nodiscard]] FineUnit build_fine_unit(const ChunkSources& sources, std::uint32_t unit);

/// The chunks below a chunk of the base level of a terrain with insets, those that exist; exact ones are regular. All of them
/// are given back with their payloads. Any thread.
[[nodiscard]] std::vector<IrregularChunk> build_inset_block(const ChunkSources& sources, const InsetCoverage& coverage,
                                                            const terrain::ChunkKey& block);

}  // namespace tedavis::host_sim
