/// Third pass (thesis 6.2.2.1): runs the tasks of a group's calls and writes their output and the remaining words to its new
/// blocks. Any thread, one per group. Groups are read while others are written, so old blocks are kept until all groups are
/// done.
#pragma once

#include "render_core/raytrace/stream/allocate_round.hpp"
#include "render_core/raytrace/stream/segment.hpp"

namespace tedavis::raytrace {

/// `group` is one of `groups`.
void execute_group(base::Span<const BlockGroup> groups, BlockGroup& group, const TaskNetwork& network, const RoundRoom& room,
                   BlockPool& pool, Segment& segment);

}  // namespace tedavis::raytrace
