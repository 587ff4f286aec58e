/// Adds the stages of a terrain build that insets need; without insets none.
#pragma once

#include "host_sim/terrain_builder/build_stages.hpp"

namespace tedavis::host_sim {

/// Stages after those of the coarse posts: fine posts, and the coarse ones that they change.
void add_inset_post_stages(BuildParts& parts, std::vector<BuildStage>& stages);
/// Stages after those of the coarse chunks: fine chunks, and the errors of coarse ones at fine posts.
void add_inset_chunk_stages(BuildParts& parts, std::vector<BuildStage>& stages);
/// Stages before those that finish the coarse entries: they finish the fine ones.
void add_inset_entry_stages(BuildParts& parts, std::vector<BuildStage>& stages);

[[nodiscard]] std::uint64_t inset_chunk_count(const BuildParts& parts);

}  // namespace tedavis::host_sim
