/// Iterates over the calls of a group of blocks. Words are scanned 64 at a time, so that literals cost very little.
#pragma once

#include "render_core/raytrace/stream/block_group.hpp"
#include "render_core/raytrace/stream/lowest_bit.hpp"

namespace tedavis::raytrace {

struct FoundCall {
    std::uint32_t call = 0;
    std::uint32_t place = 0;   ///< words of the group before the call
    std::uint32_t before = 0;  ///< literals between the previous call, or the group's beginning, and this one
    bool is_first = false;
};

class CallScan {
public:
    CallScan(const BlockPool& pool, const BlockGroup& group) : pool_(pool), block_(group.first_block), left_(group.blocks) {
        if (left_ > 0) enter();
    }

    [[nodiscard]] bool next(FoundCall& found) {
        while (bits_ == 0) {
            if (++at_ < parts_) {
                bits_ = pool_.call_bits(block_)[at_];
                continue;
            }
            if (left_ <= 1) return false;
            --left_;
            base_ += pool_.block(block_).words;
            block_ = pool_.block(block_).next;
            enter();
        }
        const std::uint32_t offset = at_ * 64 + lowest_bit(bits_);
        bits_ &= bits_ - 1;
        found = {pool_.words(block_)[offset], base_ + offset, base_ + offset - behind_, behind_ == 0};
        behind_ = base_ + offset + 1;
        return true;
    }

private:
    void enter() {
        at_ = 0;
        parts_ = (pool_.block(block_).words + 63) / 64;
        bits_ = pool_.call_bits(block_)[0];
    }

    const BlockPool& pool_;
    std::uint32_t block_, left_;
    std::uint32_t base_ = 0, at_ = 0, parts_ = 0, behind_ = 0;
    std::uint64_t bits_ = 0;
};

}  // namespace tedavis::raytrace
