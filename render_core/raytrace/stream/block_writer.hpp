/// Fills blocks with tokens, one after the other, each to its end but for the last.
#pragma once

#include "render_core/raytrace/stream/block_cursor.hpp"

namespace tedavis::raytrace {

class BlockWriter {
public:
    /// `ids`: free blocks, as many as all that is written needs.
    BlockWriter(BlockPool& pool, const std::uint32_t* ids, std::uint32_t count) : pool_(pool), ids_(ids), count_(count) {}

    /// Literals, but for the words at `call_places`, which are counted from `first` words before `words`.
    void write(const std::uint32_t* words, std::uint32_t count, const std::uint16_t* call_places, std::uint32_t calls,
               std::uint32_t first);
    /// Copies tokens from where the cursor is, which goes on behind them.
    void copy(BlockCursor& from, std::uint32_t count);
    /// Links the blocks.
    void finish();

    [[nodiscard]] std::uint32_t words() const { return words_; }
    [[nodiscard]] std::uint32_t blocks() const { return (words_ + pool_.block_words() - 1) >> pool_.block_shift(); }

private:
    void write_words(const std::uint32_t* words, std::uint32_t count);
    void mark_call(std::uint32_t place) {
        const std::uint32_t id = ids_[place >> pool_.block_shift()];
        pool_.mark_call(id, place & (pool_.block_words() - 1));
    }

    BlockPool& pool_;
    const std::uint32_t* ids_;
    std::uint32_t count_;
    std::uint32_t words_ = 0;
};

}  // namespace tedavis::raytrace
