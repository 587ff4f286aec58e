/// Consecutive blocks of a stream that one worker rewrites, and what the three passes say of them.
#pragma once

#include "render_core/raytrace/stream/block_writer.hpp"
#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::raytrace {

/// Calls done, and how full the kernels were: lanes counts what the batches had room for.
struct RewriteCounts {
    std::uint64_t calls = 0;
    std::uint64_t batches = 0;
    std::uint64_t lanes = 0;
};

struct BlockGroup {
    std::uint32_t first_block = kNoBlock, last_block = kNoBlock;
    std::uint32_t blocks = 0, words = 0;
    std::uint32_t calls = 0;  ///< as in TokenBlock

    /// Decode. The first call may begin in groups before, so allocate judges it.
    std::uint32_t before_first = 0;  ///< words before it
    std::uint32_t first_call = 0;
    std::uint32_t behind_last = 0;   ///< words behind the last call; all where there is none
    bool runs_steady = false;        ///< there are further calls, complete, that do not lengthen the stream
    std::uint64_t growth = 0;        ///< words by which further calls that are complete may lengthen it
    std::uint32_t first_growth = 0;  ///< the first of these

    /// Allocate.
    bool first_runs = false;
    std::uint32_t own_growth = 0;  ///< of the first call, if it runs
    bool leads = false;            ///< no further call before this group's may lengthen the stream
    std::uint64_t growth_before = 0;
    std::uint32_t borrowed = 0;  ///< words of the first call that lie in groups before
    std::uint32_t lender = 0, lender_offset = 0;
    std::uint32_t lent = 0;  ///< last words that belong to a call of a later group
    bool is_rewritten = false;
    BlockAllowance given;

    /// Execute.
    std::uint32_t new_words = 0, new_blocks = 0, new_first = kNoBlock, new_last = kNoBlock;
    RewriteCounts counts;
    WriterFault fault = WriterFault::none;
    TaskId fault_task = kNoTask;
};

}  // namespace tedavis::raytrace
