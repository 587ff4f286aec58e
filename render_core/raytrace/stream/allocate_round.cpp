#include "render_core/raytrace/stream/allocate_round.hpp"

#include <algorithm>

namespace tedavis::raytrace {
namespace {

/// The last words of the groups before `borrower` go to its first call.
void borrow_words(base::Span<BlockGroup> groups, std::size_t borrower) {
    std::uint32_t left = groups[borrower].borrowed;
    for (std::size_t n = borrower; left > 0 && n > 0;) {
        BlockGroup& lender = groups[--n];
        lender.lent = std::min(left, lender.behind_last);
        left -= lender.lent;
        groups[borrower].lender = static_cast<std::uint32_t>(n);
        groups[borrower].lender_offset = lender.words - lender.lent;
    }
    TEDAVIS_CHECK(left == 0);
}

/// How much of a group's growth behind its first call may be admitted, at most.
std::uint64_t admitted_growth(const BlockGroup& group, const RoundRoom& room) {
    const std::uint64_t left = room.all > group.growth_before ? room.all - group.growth_before : 0;
    const std::uint64_t leading = group.leads && group.first_growth <= room.first ? group.first_growth : 0;
    return std::max(std::min(group.growth, left), leading);
}

}  // namespace

bool allocate_round(base::Span<BlockGroup> groups, const TaskNetwork& network, const RoundRoom& room) {
    std::uint64_t growth = 0;
    std::uint32_t literals = 0;  // that lie together before the group
    bool all_admitted = true;
    for (std::size_t n = 0; n < groups.size(); ++n) {
        BlockGroup& group = groups[n];
        if (group.calls > 0) {
            const CallShape shape = network.shape(group.first_call);
            const bool is_complete = shape.is_known && shape.arguments <= literals + group.before_first;
            group.first_runs = is_complete && room.admits(growth, shape.growth, growth == 0);
            all_admitted = all_admitted && (group.first_runs || !is_complete);
            if (is_complete) growth += shape.growth;
            if (group.first_runs) group.own_growth = shape.growth;
            if (group.first_runs && shape.arguments > group.before_first) {
                group.borrowed = shape.arguments - group.before_first;
                borrow_words(groups, n);
            }
        }
        group.leads = growth == 0;
        group.growth_before = growth;
        growth += group.growth;
        literals = group.calls > 0 ? group.behind_last : literals + group.words;
        all_admitted = all_admitted && (group.growth == 0 || room.admits(group.growth_before, group.growth, false) ||
                                        (group.leads && group.first_growth == group.growth && group.growth <= room.first));
    }
    return all_admitted;
}

void give_blocks(base::Span<BlockGroup> groups, const RoundRoom& room, const EarlyEnds& early, BlockPool& pool) {
    std::uint32_t all = 0;
    for (BlockGroup& group : groups) {
        const std::uint32_t size = pool.block_words();
        const std::uint64_t further = admitted_growth(group, room);
        const bool is_loose = group.blocks > (group.words + size - 1) / size;
        group.is_rewritten = group.first_runs || group.runs_steady || further > 0 || group.lent > 0 || is_loose;
        if (!group.is_rewritten) continue;
        const std::uint64_t most = group.words - group.lent + group.borrowed + further + group.own_growth;
        group.given.early_ends = early.most / static_cast<std::uint32_t>(groups.size());
        group.given.calls_of_early = early.calls;
        group.given.count = static_cast<std::uint32_t>((most + size - 1) / size) + group.given.early_ends;
        all += group.given.count;
    }
    const std::uint32_t* ids = pool.take(all);
    TEDAVIS_CHECK(ids != nullptr);  // the pool is sized for all that a round admits
    for (BlockGroup& group : groups) {
        group.given.ids = ids;
        ids += group.given.count;
    }
}

}  // namespace tedavis::raytrace
