/// A pool of blocks of a fixed number of words; a token stream is a linked list of them (thesis 6.2.2.1).
///
/// Memory  from an arena, at start. Thread  one caller uses the list of free blocks; each block may be written by a different
/// thread.
#pragma once

#include <algorithm>
#include <cstring>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/raytrace/stream/token.hpp"

namespace tedavis::raytrace {

inline constexpr std::uint32_t kNoBlock = 0xffffffff;
inline constexpr std::uint32_t kMinBlockWords = 64, kMaxBlockWords = 4096;

struct TokenBlock {
    std::uint32_t next = kNoBlock;
    std::uint32_t words = 0;
    std::uint32_t calls = 0;  ///< calls in the block; a token counts as many as it stands for, 1 or more
};

class BlockPool {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t block_words, std::uint32_t blocks);
    /// Allocates blocks; `block_words` is a power of two within the limits. Returns false where the arena is too small.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t block_words, std::uint32_t blocks);

    [[nodiscard]] std::uint32_t block_words() const { return block_words_; }
    [[nodiscard]] TokenBlock& block(std::uint32_t id) { return blocks_.data()[id]; }
    [[nodiscard]] const TokenBlock& block(std::uint32_t id) const { return blocks_.data()[id]; }
    [[nodiscard]] std::uint32_t* words(std::uint32_t id) { return words_.data() + std::size_t{id} * block_words_; }
    [[nodiscard]] const std::uint32_t* words(std::uint32_t id) const { return words_.data() + std::size_t{id} * block_words_; }
    /// One bit per word, the lowest first: set for calls.
    [[nodiscard]] std::uint64_t* call_bits(std::uint32_t id) { return call_bits_.data() + std::size_t{id} * (block_words_ / 64); }
    [[nodiscard]] const std::uint64_t* call_bits(std::uint32_t id) const {
        return call_bits_.data() + std::size_t{id} * (block_words_ / 64);
    }

    /// Resets a block to empty.
    void open(std::uint32_t id) {
        blocks_.data()[id] = {};
        std::memset(call_bits(id), 0, block_words_ / 8);
    }
    /// Marks a written word as a call.
    void mark_call(std::uint32_t id, std::uint32_t place) {
        call_bits(id)[place / 64] |= std::uint64_t{1} << (place % 64);
        block(id).calls += std::max<std::uint32_t>(1, call_count(words(id)[place]));
    }

    /// Returns the numbers of `count` free blocks, valid until the next take() or give_back(), or null where there are fewer.
    [[nodiscard]] std::uint32_t* take(std::uint32_t count);
    /// Returns a block to the pool; the last returned block is reused first, since it is still in the caches.
    void give_back(std::uint32_t id);

private:
    std::uint32_t block_words_ = 0, free_count_ = 0;
    base::Span<TokenBlock> blocks_;
    base::Span<std::uint32_t> words_;
    base::Span<std::uint64_t> call_bits_;
    base::Span<std::uint32_t> free_;
};

}  // namespace tedavis::raytrace
