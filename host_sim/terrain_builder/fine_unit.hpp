/// One unit of the build: all chunks of levels 0 to kUnitLevel over its domain, from its posts.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/chunk_assembly.hpp"
#include "host_sim/terrain_builder/ground.hpp"
#include "host_sim/terrain_builder/inset_coverage.hpp"
#include "host_sim/terrain_builder/part_store.hpp"
#include "host_sim/terrain_builder/tdb_layout.hpp"

namespace tedavis::host_sim {

/// The sources of all chunks.
struct ChunkSources {
    const BuildPlan& plan;
    const TdbLayout& layout;
    const PostWindows& posts;
    const LineLevels& lines;
    const Steepness& slopes;
    PartStore& store;
    std::uint32_t lift = 0;  ///< difference between levels of the database and those of the plan
};

/// A chunk whose place in the file is not known beforehand.
struct IrregularChunk {
    terrain::ChunkEntry entry{};  ///< without its payload's offset
    std::vector<std::uint8_t> payload;
};

struct FineUnit {
    std::vector<terrain::ChunkEntry> regular;  ///< payloads are in the store
    std::vector<IrregularChunk> irregular;
};

/// Builds a unit. Bounds and offsets of irregular payloads are set later. Any thread.
[[nodiscard]] FineUnit build_fine_unit(const ChunkSources& sources, std::uint32_t unit);

/// Builds the existing chunks below a chunk of the base level of a terrain with insets; exact ones are regular. All are returned
/// with their payloads. Any thread.
[[nodiscard]] std::vector<IrregularChunk> build_inset_block(const ChunkSources& sources, const InsetCoverage& coverage,
                                                            const terrain::ChunkKey& block);

}  // namespace tedavis::host_sim
