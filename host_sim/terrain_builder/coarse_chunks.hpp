/// Chunks above the units: their meshes from the vertices of the meshes below and from posts spread over them, their errors from
/// all posts, unit by unit.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/chunk_proof.hpp"
#include "host_sim/terrain_builder/entries_file.hpp"
#include "host_sim/terrain_builder/fine_unit.hpp"

namespace tedavis::host_sim {

/// A chunk of a level above kUnitLevel; all chunks of the levels below have their entries. Errors, bounds and the payload's
/// offset remain to be set. Any thread.
[[nodiscard]] IrregularChunk build_coarse_chunk(const ChunkSources& sources, const EntriesFile& entries,
                                                const terrain::ChunkKey& key);

struct CoarseErrors {
    terrain::ChunkKey chunk;
    ChunkErrors errors;
};
/// What the posts of a unit say about the chunks above it; taken together over all units, their errors. Any thread.
[[nodiscard]] std::vector<CoarseErrors> measure_above(const ChunkSources& sources, const EntriesFile& entries,
                                                      std::uint32_t unit);
/// What the fine posts of a block, a chunk of the base level that has children, say about that chunk and those above it: keys
/// of the database. `entries` are the coarse ones. Any thread.
[[nodiscard]] std::vector<CoarseErrors> measure_inset_block(const ChunkSources& fine, const ChunkSources& coarse,
                                                            const EntriesFile& entries, const terrain::ChunkKey& block);

}  // namespace tedavis::host_sim
