/// The stages of a terrain build that insets add. Without insets there are none.
#pragma once

#include "host_sim/terrain_builder/build_stages.hpp"

namespace tedavis::host_sim {

/// After the coarse posts: fine posts, and the coarse ones that they change.
void add_inset_post_stages(BuildParts& parts, std::vector<BuildStage>& stages);
/// After the coarse chunks: fine chunks, and what they say about the coarse ones.
void add_inset_chunk_stages(BuildParts& parts, std::vector<BuildStage>& stages);
/// Before the coarse entries are finished: the fine ones.
void add_inset_entry_stages(BuildParts& parts, std::vector<BuildStage>& stages);

[[nodiscard]] std::uint64_t inset_chunk_count(const BuildParts& parts);

}  // namespace tedavis::host_sim
