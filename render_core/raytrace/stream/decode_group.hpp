/// First pass (thesis 6.2.2.1): finds the calls of a group that can be executed, and its largest possible length. Any thread,
/// one per group.
#pragma once

#include "render_core/raytrace/stream/block_group.hpp"

namespace tedavis::raytrace {

void decode_group(const BlockPool& pool, const TaskNetwork& network, BlockGroup& group);

}  // namespace tedavis::raytrace
