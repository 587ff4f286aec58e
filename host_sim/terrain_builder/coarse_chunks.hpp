/// Chunks above the units: their meshes from the vertices of the meshes below and from posts spread over them, their errors from
/// all posts, unit by unit.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/chunk_proof.hpp"
#include "host_sim/terrain_builder/entries_file.hpp"
#include "host_sim/terrain_builder/fine_unit.hpp"

namespace tedavis::host_sim {

/// Builds a chunk of a level above kUnitLevel; the entries of all chunks of the levels below must exist. Errors, bounds and the
/// payload's offset are set later. Any thread.
[[nodiscard]] IrregularChunk build_coarse_chunk(const ChunkSources& sources, const EntriesFile& entries,
                                                const terrain::ChunkKey& key);

struct CoarseErrors {
    terrain::ChunkKey chunk;
    ChunkErrors errors;
};
/// Returns the errors of the chunks above a unit at the unit's posts; their errors are the largest of all units. Any thread.
[[nodiscard]] std::vector<CoarseErrors> measure_above(const ChunkSources& sources, const EntriesFile& entries,
                                                      std::uint32_t unit);
/// Returns the errors of a block (a chunk of the base level that has children) and of the chunks above it at the block's fine
/// posts, with keys of the database. `entries` are the coarse ones. Any thread.
[[nodiscard]] std::vector<CoarseErrors> measure_inset_block(const ChunkSources& fine, const ChunkSources& coarse,
                                                            const EntriesFile& entries, const terrain::ChunkKey& block);

}  // namespace tedavis::host_sim
