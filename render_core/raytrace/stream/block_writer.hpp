/// Writes tokens to blocks; all blocks are filled completely, except the last one and those that end early.
#pragma once

#include "render_core/raytrace/stream/block_cursor.hpp"

namespace tedavis::raytrace {

/// What a group's blocks may come to: so many, of which some may end early, behind a call by which they have so many,
/// or more where many calls are written at once.
struct BlockAllowance {
    const std::uint32_t* ids = nullptr;  ///< free blocks
    std::uint32_t count = 0;
    std::uint32_t early_ends = 0;
    std::uint32_t calls_of_early = 0;
};

class BlockWriter {
public:
    BlockWriter(BlockPool& pool, const BlockAllowance& allowance) : pool_(pool), allowance_(allowance) {}

    /// Writes words as literals, except those at `call_places` (ascending), which are counted from `first` words before
    /// `words`.
    void write(const std::uint32_t* words, std::uint32_t count, const std::uint16_t* call_places, std::uint32_t calls,
               std::uint32_t first);
    /// Copies tokens from the cursor, which is advanced behind them.
    void copy(BlockCursor& from, std::uint32_t count);
    /// Links the blocks.
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
