/// Makes single chunks: the regular ones of level 0 and the triangulated ones above.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/chunk_assembly.hpp"
#include "host_sim/terrain_builder/chunk_tin.hpp"
#include "host_sim/terrain_builder/ground.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::host_sim {

/// Makes a chunk of which every 2^level-th post is a vertex. The window must contain the chunk's posts and, where they exist,
/// their neighbours.
[[nodiscard]] ChunkDraft make_regular_chunk(const BuildPlan& plan, const LineLevels& lines, const terrain::ChunkKey& key,
                                            const LatticeWindow& window, const PostPlaces& places);

/// Returns the triangles of a regular chunk, which the file does not store.
[[nodiscard]] std::vector<std::uint16_t> regular_triangles(const terrain::RegularGrid& grid);

/// Triangulates a chunk of level 1 or above. `border_posts` are those of chunk_border() with heights and classes; `candidates`
/// and the result are relative to the chunk's corner. With `surface`, a window of all its posts, the mesh also keeps the
/// tolerance between posts.
[[nodiscard]] Tin triangulate_chunk(const BuildPlan& plan, const Steepness& slopes, const terrain::ChunkKey& key,
                                    std::vector<TinPost> border_posts, std::vector<TinPost> candidates,
                                    const LatticeWindow* surface);

/// Sorts the triangles, first those with a border vertex that is absent beside a coarser neighbour, and sets the counts.
void set_triangles(ChunkDraft& draft, std::vector<std::uint16_t> triangles);

/// Returns the bytes of a chunk in the file. `lift` is added to the levels of the chunk's plan, whose posts are 2^lift posts of
/// the database apart.
[[nodiscard]] std::vector<std::uint8_t> payload_of(const ChunkDraft& draft, std::uint32_t lift);

}  // namespace tedavis::host_sim
