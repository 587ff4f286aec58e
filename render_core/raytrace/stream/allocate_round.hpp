/// Second pass (thesis 6.2.2.1): which calls are executed, where those that span groups begin, and which blocks each group gets.
///
/// All calls that are complete when the round begins are executed, but for those that lengthen the stream beyond its room: of
/// these, in the order of the stream, as many as fit without the reserve, and in any case the first if it fits with it. That
/// depends on the stream and its capacity alone, not on blocks, groups or workers. One thread.
#pragma once

#include "render_core/raytrace/stream/block_group.hpp"

namespace tedavis::raytrace {

struct RoundRoom {
    std::uint64_t all = 0;    ///< words by which calls may lengthen the stream
    std::uint64_t first = 0;  ///< the first of them alone

    [[nodiscard]] bool admits(std::uint64_t growth_before, std::uint64_t growth, bool is_first) const {
        return growth == 0 || growth_before + growth <= all || (is_first && growth <= first);
    }
};

/// False where calls have to wait for room.
[[nodiscard]] bool allocate_round(base::Span<BlockGroup> groups, const TaskNetwork& network, const RoundRoom& room);

/// Blocks that may end early, of all groups together, and how many calls they have then.
struct EarlyEnds {
    std::uint32_t most = 0;
    std::uint32_t calls = 0;
};

/// Blocks for what the groups may come to, from the pool.
void give_blocks(base::Span<BlockGroup> groups, const RoundRoom& room, const EarlyEnds& early, BlockPool& pool);

}  // namespace tedavis::raytrace
