#include "render_core/raytrace/stream/block_pool.hpp"

namespace tedavis::raytrace {

std::uint64_t BlockPool::bytes_needed(std::uint32_t block_words, std::uint32_t blocks) {
    const std::uint64_t of_block =
        sizeof(TokenBlock) + sizeof(std::uint32_t) * (std::uint64_t{block_words} + 1) + block_words / 8;
    return of_block * blocks + 4 * alignof(std::max_align_t);
}

bool BlockPool::start(base::Arena& arena, std::uint32_t block_words, std::uint32_t blocks) {
    TEDAVIS_CHECK(block_words >= kMinBlockWords && block_words <= kMaxBlockWords && (block_words & (block_words - 1)) == 0);
    block_words_ = block_words;
    call_bits_ = arena.allocate_array<std::uint64_t>(std::size_t{blocks} * (block_words / 64));
    words_ = arena.allocate_array<std::uint32_t>(std::size_t{blocks} * block_words);
    blocks_ = arena.allocate_array<TokenBlock>(blocks);
    free_ = arena.allocate_array<std::uint32_t>(blocks);
    if (blocks == 0 || call_bits_.empty() || words_.empty() || blocks_.empty() || free_.empty()) return false;
    free_count_ = blocks;
    for (std::uint32_t n = 0; n < blocks; ++n) free_[n] = blocks - 1 - n;
    return true;
}

std::uint32_t* BlockPool::take(std::uint32_t count) {
    if (count > free_count_) return nullptr;
    free_count_ -= count;
    return free_.data() + free_count_;
}

void BlockPool::give_back(std::uint32_t id) { free_[free_count_++] = id; }

}  // namespace tedavis::raytrace
