/// Writes tokens to blocks; all blocks are filled completely, except the last one and those that end early.
#pragma once

#include "render_core/raytrace/stream/block_cursor.hpp"

namespace tedavis::raytrace {

/// The blocks that a group may fill: `count` blocks of `ids`. At most `early_ends` of them may end before they are full: a block
/// ends after a call as soon as it holds `calls_of_early` calls. Where many calls are written at once, write() raises this
/// number, so that the calls are spread over all blocks that may end early.
struct BlockAllowance {
    const std::uint32_t* ids = nullptr;  ///< free blocks
    std::uint32_t count = 0;
    std::uint32_t early_ends = 0;
    std::uint32_t calls_of_early = 0;
};

/// Fills free blocks one after the other; running out of them is a failed TEDAVIS_CHECK.
class BlockWriter {
public:
    BlockWriter(BlockPool& pool, const BlockAllowance& allowance) : pool_(pool), allowance_(allowance) {}

    /// Writes `count` words. The words at `call_places` (ascending) are calls, all others literals. Places are counted from
    /// `first` words before `words`.
    void write(const std::uint32_t* words, std::uint32_t count, const std::uint16_t* call_places, std::uint32_t calls,
               std::uint32_t first);
    /// Copies `count` words and their call marks, and advances the cursor past them.
    void copy(BlockCursor& from, std::uint32_t count);
    /// Links the blocks into a list, in the order in which they were filled.
    void finish();

    [[nodiscard]] std::uint32_t words() const { return words_; }
    [[nodiscard]] std::uint32_t blocks() const { return blocks_; }

private:
    [[nodiscard]] std::uint32_t room();
    [[nodiscard]] bool ends_early();
    void add(std::uint32_t count);

    BlockPool& pool_;
    BlockAllowance allowance_;
    std::uint32_t id_ = kNoBlock;  ///< number of the current block
    std::uint32_t blocks_ = 0, words_ = 0;
    bool is_ended_ = true;
};

}  // namespace tedavis::raytrace
