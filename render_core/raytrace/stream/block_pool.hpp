/// Blocks of a fixed number of words, made once and handed round: a token stream is a linked list of them (thesis 6.2.2.1).
///
/// Memory  an arena's, at start. Thread  the list of free blocks is one caller's; each block may be written by another.
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
    std::uint32_t calls = 0;  ///< among them, each token as many as it stands for, 1 or more
};

class BlockPool {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t block_words, std::uint32_t blocks);
    /// `block_words` a power of two within the limits. False where the arena has no room.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t block_words, std::uint32_t blocks);

    [[nodiscard]] std::uint32_t block_words() const { return block_words_; }
    [[nodiscard]] TokenBlock& block(std::uint32_t id) { return blocks_.data()[id]; }
    [[nodiscard]] const TokenBlock& block(std::uint32_t id) const { return blocks_.data()[id]; }
    [[nodiscard]] std::uint32_t* words(std::uint32_t id) { return words_.data() + std::size_t{id} * block_words_; }
    [[nodiscard]] const std::uint32_t* words(std::uint32_t id) const { return words_.data() + std::size_t{id} * block_words_; }
    /// Which of the words are calls, a bit each, the lowest first.
    [[nodiscard]] std::uint64_t* call_bits(std::uint32_t id) { return call_bits_.data() + std::size_t{id} * (block_words_ / 64); }
    [[nodiscard]] const std::uint64_t* call_bits(std::uint32_t id) const {
        return call_bits_.data() + std::size_t{id} * (block_words_ / 64);
    }

    /// An empty block.
    void open(std::uint32_t id) {
        blocks_.data()[id] = {};
        std::memset(call_bits(id), 0, block_words_ / 8);
    }
    /// A word that was written is a call.
    void mark_call(std::uint32_t id, std::uint32_t place) {
        call_bits(id)[place / 64] |= std::uint64_t{1} << (place % 64);
        block(id).calls += std::max<std::uint32_t>(1, call_count(words(id)[place]));
    }

    /// The numbers of `count` free blocks; they stay where they are until the next take() or give_back(). Null where there are
    /// fewer.
    [[nodiscard]] std::uint32_t* take(std::uint32_t count);
    /// Last come, first taken: what is in the caches is used first.
    void give_back(std::uint32_t id);

private:
    std::uint32_t block_words_ = 0, free_count_ = 0;
    base::Span<TokenBlock> blocks_;
    base::Span<std::uint32_t> words_;
    base::Span<std::uint64_t> call_bits_;
    base::Span<std::uint32_t> free_;
};

}  // namespace tedavis::raytrace
