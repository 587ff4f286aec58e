/// Consecutive blocks of a stream that one worker rewrites, with the results of the three passes.
#pragma once

#include "render_core/raytrace/stream/block_writer.hpp"
#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::raytrace {

/// Counts of executed calls and of batches (task.hpp). `lanes`: the calls of each batch rounded up to whole kernels; `calls`
/// divided by `lanes` is the utilisation of the kernels.
struct RewriteCounts {
    std::uint64_t calls = 0;
    std::uint64_t batches = 0;
    std::uint64_t lanes = 0;
};

struct BlockGroup {
    std::uint32_t first_block = kNoBlock, last_block = kNoBlock;
    std::uint32_t blocks = 0, words = 0;
    std::uint32_t calls = 0;  ///< as in TokenBlock

    /// Results of the decode pass. The arguments of the first call may lie in earlier groups, so the allocate pass decides on it.
    /// `Further` calls are those after the group's first; a further call is complete if all its arguments lie in the group.
    std::uint32_t before_first = 0;  ///< words before the first call
    std::uint32_t first_call = 0;
    std::uint32_t behind_last = 0;  ///< words behind the last call; all words where there is no call
    bool runs_steady = false;  ///< there are further complete calls that cannot lengthen the stream; these are always executed
    std::uint64_t growth = 0;  ///< sum of the words by which the further complete calls may lengthen the stream
    std::uint32_t first_growth = 0;  ///< share in `growth` of the first call that may lengthen it

    /// Results of the allocate pass.
    bool first_runs = false;
    std::uint32_t own_growth = 0;  ///< words by which the first call may lengthen the stream, if it runs
    /// growth_before is 0: if one of the further calls may lengthen the stream, it is the first of the stream that may.
    bool leads = false;
    /// Words by which the complete calls before the further ones may lengthen the stream, executed or not.
    std::uint64_t growth_before = 0;
    std::uint32_t borrowed = 0;  ///< words of the first call that lie in earlier groups
    /// Index of the earliest group that holds borrowed words, and the offset of the first of them in it, in words.
    std::uint32_t lender = 0, lender_offset = 0;
    std::uint32_t lent = 0;  ///< last words of this group that belong to a call of a later group
    bool is_rewritten = false;
    BlockAllowance given;

    /// Results of the execute pass.
    std::uint32_t new_words = 0, new_blocks = 0, new_first = kNoBlock, new_last = kNoBlock;
    RewriteCounts counts;
    WriterFault fault = WriterFault::none;
    TaskId fault_task = kNoTask;
};

}  // namespace tedavis::raytrace
