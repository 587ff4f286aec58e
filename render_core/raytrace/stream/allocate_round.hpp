/// Second pass (thesis 6.2.2.1): decides which calls are executed, where calls that span groups begin, and which blocks each
/// group gets.
///
/// All calls that are complete when the round begins are executed, except calls that would lengthen the stream beyond its
/// capacity: of these, in stream order, as many as fit without the reserve, and always the first if it fits with the reserve.
/// The decision depends only on the stream and its capacity, not on blocks, groups or workers. One thread.
#pragma once

#include "render_core/raytrace/stream/block_group.hpp"

namespace tedavis::raytrace {

struct RoundRoom {
    std::uint64_t all = 0;    ///< words by which all calls may lengthen the stream
    std::uint64_t first = 0;  ///< words for the first of them alone

    [[nodiscard]] bool admits(std::uint64_t growth_before, std::uint64_t growth, bool is_first) const {
        return growth == 0 || growth_before + growth <= all || (is_first && growth <= first);
    }
};

/// Returns false where calls have to wait for room.
[[nodiscard]] bool allocate_round(base::Span<BlockGroup> groups, const TaskNetwork& network, const RoundRoom& room);

/// Number of blocks of all groups that may end early, and the calls that such a block has.
struct EarlyEnds {
    std::uint32_t most = 0;
    std::uint32_t calls = 0;
};

/// Takes blocks from the pool for the largest possible output of the groups.
void give_blocks(base::Span<BlockGroup> groups, const RoundRoom& room, const EarlyEnds& early, BlockPool& pool);

}  // namespace tedavis::raytrace
