/// One unit of the build: all chunks of levels 0 to kUnitLevel over its domain, from its posts.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/border_lines.hpp"
#include "host_sim/terrain_builder/chunk_assembly.hpp"
#include "host_sim/terrain_builder/part_store.hpp"
#include "host_sim/terrain_builder/slope_map.hpp"
#include "host_sim/terrain_builder/tdb_layout.hpp"

namespace tedavis::host_sim {

/// What all chunks are made from.
struct ChunkSources {
    const BuildPlan& plan;
    const TdbLayout& layout;
    const PostsFile& posts;
    const BorderLines& lines;
    const SlopeMap& slopes;
    PartStore& store;
};

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

}  // namespace tedavis::host_sim
