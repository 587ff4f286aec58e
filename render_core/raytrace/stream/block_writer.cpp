#include "render_core/raytrace/stream/block_writer.hpp"

#include <algorithm>

#include "render_core/raytrace/stream/lowest_bit.hpp"

namespace tedavis::raytrace {

/// Words that go into the present block, or a new one.
std::uint32_t BlockWriter::room() {
    if (is_ended_) {
        TEDAVIS_CHECK(blocks_ < allowance_.count);
        id_ = allowance_.ids[blocks_++];
        pool_.open(id_);
        is_ended_ = false;
    }
    return pool_.block_words() - pool_.block(id_).words;
}

/// Asked behind a call.
bool BlockWriter::ends_early() {
    if (allowance_.early_ends == 0 || pool_.block(id_).calls < allowance_.calls_of_early) return false;
    --allowance_.early_ends;
    is_ended_ = true;
    return true;
}

void BlockWriter::add(std::uint32_t count) {
    pool_.block(id_).words += count;
    words_ += count;
    is_ended_ = is_ended_ || pool_.block(id_).words == pool_.block_words();
}

void BlockWriter::write(const std::uint32_t* words, std::uint32_t count, const std::uint16_t* call_places, std::uint32_t calls,
                        std::uint32_t first) {
    // So many calls at once are spread over all blocks that may end early, not over the first of them.
    if (allowance_.early_ends > 0)
        allowance_.calls_of_early = std::max(allowance_.calls_of_early, calls / (allowance_.early_ends + 1) + 1);
    for (std::uint32_t written = 0, call = 0; written < count;) {
        std::uint32_t now = std::min(count - written, room());
        const std::uint32_t offset = pool_.block(id_).words;
        std::memcpy(pool_.words(id_) + offset, words + written, now * sizeof *words);
        for (bool goes_on = true; goes_on && call < calls && call_places[call] - first < written + now; ++call) {
            const std::uint32_t place = call_places[call] - first - written;
            pool_.mark_call(id_, offset + place);
            goes_on = !ends_early();
            if (!goes_on) now = place + 1;
        }
        add(now);
        written += now;
    }
}

void BlockWriter::copy(BlockCursor& from, std::uint32_t count) {
    while (count > 0) {
        std::uint32_t now = std::min({count, from.together(), room()});
        TEDAVIS_CHECK(now > 0);
        const std::uint32_t start = from.offset(), offset = pool_.block(id_).words;
        std::memcpy(pool_.words(id_) + offset, from.words(), now * sizeof(std::uint32_t));
        const std::uint64_t* bits = pool_.call_bits(from.block());
        for (std::uint32_t at = start / 64; at * 64 < start + now; ++at) {
            std::uint64_t left = bits[at];
            if (at * 64 < start) left &= ~std::uint64_t{0} << (start % 64);
            for (; left != 0; left &= left - 1) {
                const std::uint32_t place = at * 64 + lowest_bit(left);
                if (place >= start + now) break;
                pool_.mark_call(id_, offset + place - start);
                if (ends_early()) now = place + 1 - start;
            }
        }
        add(now);
        from.skip(now);
        count -= now;
    }
}

void BlockWriter::finish() {
    for (std::uint32_t n = 0; n < blocks_; ++n)
        pool_.block(allowance_.ids[n]).next = n + 1 < blocks_ ? allowance_.ids[n + 1] : kNoBlock;
}

}  // namespace tedavis::raytrace
