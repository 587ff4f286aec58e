#include "render_core/raytrace/stream/block_writer.hpp"

#include "render_core/raytrace/stream/lowest_bit.hpp"

namespace tedavis::raytrace {

void BlockWriter::write_words(const std::uint32_t* words, std::uint32_t count) {
    const std::uint32_t size = pool_.block_words();
    while (count > 0) {
        const std::uint32_t index = words_ >> pool_.block_shift(), offset = words_ & (size - 1);
        TEDAVIS_CHECK(index < count_);
        if (offset == 0) pool_.open(ids_[index]);
        const std::uint32_t now = std::min(count, size - offset);
        std::memcpy(pool_.words(ids_[index]) + offset, words, now * sizeof *words);
        words += now;
        words_ += now;
        count -= now;
    }
}

void BlockWriter::write(const std::uint32_t* words, std::uint32_t count, const std::uint16_t* call_places, std::uint32_t calls,
                        std::uint32_t first) {
    const std::uint32_t start = words_;
    write_words(words, count);
    for (std::uint32_t n = 0; n < calls; ++n) mark_call(start + call_places[n] - first);
}

void BlockWriter::copy(BlockCursor& from, std::uint32_t count) {
    while (count > 0) {
        const std::uint32_t now = std::min(count, from.together());
        TEDAVIS_CHECK(now > 0);
        const std::uint32_t start = words_, offset = from.offset();
        write_words(from.words(), now);
        const std::uint64_t* bits = pool_.call_bits(from.block());
        for (std::uint32_t at = offset / 64; at * 64 < offset + now; ++at) {
            std::uint64_t left = bits[at];
            if (at * 64 < offset) left &= ~std::uint64_t{0} << (offset % 64);
            for (; left != 0; left &= left - 1) {
                const std::uint32_t place = at * 64 + lowest_bit(left);
                if (place < offset + now) mark_call(start + place - offset);
            }
        }
        from.skip(now);
        count -= now;
    }
}

void BlockWriter::finish() {
    const std::uint32_t size = pool_.block_words(), used = blocks();
    for (std::uint32_t n = 0; n < used; ++n) {
        TokenBlock& block = pool_.block(ids_[n]);
        block.words = std::min(size, words_ - n * size);
        block.next = n + 1 < used ? ids_[n + 1] : kNoBlock;
    }
}

}  // namespace tedavis::raytrace
