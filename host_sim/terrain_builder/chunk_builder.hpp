/// Makes single chunks: the regular ones of level 0 and the triangulated ones above.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/border_lines.hpp"
#include "host_sim/terrain_builder/chunk_assembly.hpp"
#include "host_sim/terrain_builder/chunk_tin.hpp"
#include "host_sim/terrain_builder/slope_map.hpp"

namespace tedavis::host_sim {

/// Every post is a vertex. The window holds the chunk's posts and, where they exist, their neighbours.
[[nodiscard]] ChunkDraft make_regular_chunk(const BuildPlan& plan, const BorderLines& lines, std::uint32_t i, std::uint32_t j,
                                            const LatticeWindow& window, const PostPlaces& places);

/// The triangulation of a chunk of level 1 or above. `border_posts` are those of chunk_border() with heights and classes;
/// `candidates` and the result are relative to the chunk's corner. With `surface`, a window of all its posts, the mesh is held to
/// the tolerance between posts as well.
[[nodiscard]] Tin triangulate_chunk(const BuildPlan& plan, const SlopeMap& slopes, const terrain::ChunkKey& key,
                                    std::vector<TinPost> border_posts, std::vector<TinPost> candidates,
                                    const LatticeWindow* surface);

/// Puts the triangles that touch a border vertex which does not always stay first; sets their counts.
void set_triangles(ChunkDraft& draft, std::vector<std::uint16_t> triangles);

/// The file's bytes of a chunk.
[[nodiscard]] std::vector<std::uint8_t> payload_of(const ChunkDraft& draft);

}  // namespace tedavis::host_sim
