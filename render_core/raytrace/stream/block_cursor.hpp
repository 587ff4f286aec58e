/// A read position in a linked list of blocks. The caller must not read beyond the end.
#pragma once

#include "render_core/raytrace/stream/block_pool.hpp"

namespace tedavis::raytrace {

class BlockCursor {
public:
    BlockCursor(const BlockPool& pool, std::uint32_t block) : pool_(&pool), block_(block) { to_next_block(); }

    [[nodiscard]] std::uint32_t block() const { return block_; }
    [[nodiscard]] std::uint32_t offset() const { return offset_; }
    [[nodiscard]] const std::uint32_t* words() const { return pool_->words(block_) + offset_; }
    /// Words from here to the end of the block; 0 only at the end of the list.
    [[nodiscard]] std::uint32_t together() const { return block_ == kNoBlock ? 0 : pool_->block(block_).words - offset_; }

    void skip(std::uint32_t count) {
        while (count > 0) {
            const std::uint32_t now = std::min(count, together());
            TEDAVIS_CHECK(now > 0);
            offset_ += now;
            count -= now;
            to_next_block();
        }
    }
    void read(std::uint32_t* out, std::uint32_t count) {
        while (count > 0) {
            const std::uint32_t now = std::min(count, together());
            TEDAVIS_CHECK(now > 0);
            std::memcpy(out, words(), now * sizeof *out);
            out += now;
            offset_ += now;
            count -= now;
            to_next_block();
        }
    }

private:
    void to_next_block() {
        while (block_ != kNoBlock && offset_ == pool_->block(block_).words) {
            block_ = pool_->block(block_).next;
            offset_ = 0;
        }
    }

    const BlockPool* pool_;
    std::uint32_t block_;
    std::uint32_t offset_ = 0;
};

}  // namespace tedavis::raytrace
