/// One chunk of a terrain database: its entry in the directory and its payload.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/terrain_model.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

struct MadeChunk {
    terrain::ChunkEntry entry{};  ///< its offset is still 0
    std::vector<std::uint8_t> payload;
};

/// The chunk's errors are measured over every drawn triangle. `scratch` is working memory. Throws UserError when the chunk
/// cannot be represented.
[[nodiscard]] MadeChunk make_chunk(const TerrainModel& model, std::uint32_t level, std::uint32_t i, std::uint32_t j,
                                   terrain::ChunkMeshScratch& scratch);

}  // namespace tedavis::host_sim
