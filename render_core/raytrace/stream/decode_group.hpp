/// First pass (thesis 6.2.2.1): what of a group can be executed, and how long it may become. Any thread, each group by one.
#pragma once

#include "render_core/raytrace/stream/block_group.hpp"

namespace tedavis::raytrace {

void decode_group(const BlockPool& pool, const TaskNetwork& network, BlockGroup& group);

}  // namespace tedavis::raytrace
