/// Consecutive blocks of a stream that one worker rewrites, with the results of the three passes.
#pragma once

#include "render_core/raytrace/stream/block_writer.hpp"
#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::raytrace {

/// Executed calls and the utilisation of kernels: `lanes` counts the capacity of the batches.
struct RewriteCounts {
    std::uint64_t calls = 0;
    std::uint64_t batches = 0;
    std::uint64_t lanes = 0;
};

struct BlockGroup {
    std::uint32_t first_block = kNoBlock, last_block = kNoBlock;
    std::uint32_t blocks = 0, words = 0;
    std::uint32_t calls = 0;  ///< as in TokenBlock

    /// Results of decode. The first call may begin in earlier groups, so it is evaluated by allocate.
    std::uint32_t before_first = 0;  ///< words before the first call
    std::uint32_t first_call = 0;
    std::uint32_t behind_last = 0;   ///< words behind the last call; all words where there is no call
    bool runs_steady = false;        ///< there are further complete calls that do not lengthen the stream
    std::uint64_t growth = 0;        ///< words by which further complete calls may lengthen the stream
    std::uint32_t first_growth = 0;  ///< the first of these

    /// Allocate.
    bool first_runs = false;
    std::uint32_t own_growth = 0;  ///< of the first call, if it runs
    bool leads = false;            ///< no complete call before this group's further calls may lengthen the stream
    std::uint64_t growth_before = 0;
    std::uint32_t borrowed = 0;  ///< words of the first call that lie in earlier groups
    std::uint32_t lender = 0, lender_offset = 0;
    std::uint32_t lent = 0;  ///< last words of this group that belong to a call of a later group
    bool is_rewritten = false;
    BlockAllowance given;

    /// Execute.
    std::uint32_t new_words = 0, new_blocks = 0, new_first = kNoBlock, new_last = kNoBlock;
    RewriteCounts counts;
    WriterFault fault = WriterFault::none;
    TaskId fault_task = kNoTask;
};

}  // namespace tedavis::raytrace
