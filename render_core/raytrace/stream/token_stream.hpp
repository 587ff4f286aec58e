/// A program in post-order as a linked list of blocks from a fixed pool (thesis 6.2.2.1). StreamRewriter works on it.
///
/// Capacity is counted in words, independent of the block size; the pool is several times larger, for reading and writing at
/// the same time and for partly filled blocks. What does not fit is refused and counted. Memory  from an arena, at start.
#pragma once

#include "render_core/base/fault_text.hpp"
#include "render_core/base/result.hpp"
#include "render_core/raytrace/stream/block_cursor.hpp"
#include "render_core/raytrace/stream/token.hpp"

namespace tedavis::raytrace {

struct StreamSettings {
    std::uint32_t block_words = 512;            ///< 64 to 4096, a power of two
    std::uint32_t capacity_words = 128 * 1024;  ///< 2 kMaxOutputWords to 2^26
    /// The part of the capacity that only the first call that lengthens the stream may use, so that progress is always
    /// possible. A task that needs no more than this beyond its own words when its first call is always evaluated first, and
    /// whose output is not longer than its input, terminates.
    std::uint32_t reserve_words = 20 * 1024;
    std::uint32_t most_workers = 8;  ///< workers that rewrite at once, 1 to 64
};

/// Number of groups, and of blocks, per worker and round that may end early because they contain much work in few words.
inline constexpr std::uint32_t kEarlyEndsOfWorker = 8;
/// Least number of words of other groups, except the last.
[[nodiscard]] std::uint32_t least_group_words(const StreamSettings& settings);
[[nodiscard]] std::uint32_t most_groups(const StreamSettings& settings);

class TokenStream {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(const StreamSettings& settings);
    /// Returns the allocated bytes, or one sentence.
    [[nodiscard]] base::Result<std::uint64_t, base::FaultText> start(const StreamSettings& settings, base::Arena& arena);

    /// Appends tokens. Returns false, and adds nothing, where there is no room.
    [[nodiscard]] bool try_append(base::Span<const Token> tokens);
    void clear();

    [[nodiscard]] std::uint32_t words() const { return words_; }
    /// In words. `refused` counts refused appends, and rounds in which calls had to wait for room.
    [[nodiscard]] const base::ResourceUse& use() const { return use_; }
    [[nodiscard]] const StreamSettings& settings() const { return settings_; }
    /// Reads the first tokens, as many as fit, and returns their number.
    std::uint32_t read(base::Span<Token> out) const;

    // For the rewriting.

    [[nodiscard]] BlockPool& pool() { return pool_; }
    [[nodiscard]] const BlockPool& pool() const { return pool_; }
    [[nodiscard]] std::uint32_t first_block() const { return first_; }
    void set_list(std::uint32_t first, std::uint32_t last, std::uint32_t words);
    void count_refusal() { ++use_.refused; }

private:
    [[nodiscard]] bool add_block();

    StreamSettings settings_;
    BlockPool pool_;
    std::uint32_t first_ = kNoBlock, last_ = kNoBlock;
    std::uint32_t words_ = 0;
    base::ResourceUse use_;
};

}  // namespace tedavis::raytrace
