#include "render_core/raytrace/stream/token_stream.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kMinGroupWords = 128;
constexpr std::uint32_t kMaxStreamWords = 1u << 26;

std::uint32_t blocks_of(const StreamSettings& settings) {
    const std::uint32_t early = kEarlyEndsOfWorker * settings.most_workers;
    return 2 * (settings.capacity_words / settings.block_words + most_groups(settings) + early + 1);
}

/// Empty where nothing is wrong.
base::FaultText fault_of_settings(const StreamSettings& settings) {
    const std::uint32_t size = settings.block_words;
    if (size < kMinBlockWords || size > kMaxBlockWords || (size & (size - 1)) != 0)
        return "blocks of a token stream have 64 to 4096 words, a power of two; give block_words such a number";
    if (settings.capacity_words < 2 * kMaxOutputWords || settings.capacity_words > kMaxStreamWords)
        return "a token stream holds 32768 to 67108864 words; give capacity_words such a number";
    if (settings.reserve_words > settings.capacity_words)
        return "the reserve of a token stream is a part of its capacity; give reserve_words a smaller number";
    if (settings.most_workers < 1 || settings.most_workers > 64)
        return "1 to 64 workers rewrite a token stream; give most_workers such a number";
    return {};
}

}  // namespace

std::uint32_t least_group_words(const StreamSettings& settings) { return std::max(kMinGroupWords, settings.block_words); }

std::uint32_t most_groups(const StreamSettings& settings) {
    return settings.capacity_words / least_group_words(settings) + 1 + kEarlyEndsOfWorker * settings.most_workers;
}

std::uint64_t TokenStream::bytes_needed(const StreamSettings& settings) {
    return BlockPool::bytes_needed(settings.block_words, blocks_of(settings));
}

base::Result<std::uint64_t, base::FaultText> TokenStream::start(const StreamSettings& settings, base::Arena& arena) {
    const base::FaultText fault = fault_of_settings(settings);
    if (!fault.empty()) return base::fail(fault);
    const std::uint64_t before = arena.use().in_use;
    if (!pool_.start(arena, settings.block_words, blocks_of(settings)))
        return base::fail(
            base::FaultText("the blocks of the token stream do not fit its memory; give more or a smaller capacity_words"));
    settings_ = settings;
    use_.capacity = settings.capacity_words;
    return arena.use().in_use - before;
}

bool TokenStream::try_append(base::Span<const Token> tokens) {
    if (tokens.size() > settings_.capacity_words - words_) {
        ++use_.refused;
        return false;
    }
    const std::uint32_t size = settings_.block_words;
    for (const Token& token : tokens) {
        if (last_ == kNoBlock || pool_.block(last_).words == size) TEDAVIS_CHECK(add_block());
        TokenBlock& block = pool_.block(last_);
        pool_.words(last_)[block.words] = token.word;
        if (token.is_call) pool_.mark_call(last_, block.words);
        ++block.words;
    }
    words_ += static_cast<std::uint32_t>(tokens.size());
    use_.take(tokens.size());
    return true;
}

bool TokenStream::add_block() {
    const std::uint32_t* id = pool_.take(1);
    if (id == nullptr) return false;
    pool_.open(*id);
    (last_ == kNoBlock ? first_ : pool_.block(last_).next) = *id;
    last_ = *id;
    return true;
}

void TokenStream::clear() {
    for (std::uint32_t block = first_; block != kNoBlock;) {
        const std::uint32_t next = pool_.block(block).next;
        pool_.give_back(block);
        block = next;
    }
    set_list(kNoBlock, kNoBlock, 0);
}

std::uint32_t TokenStream::read(base::Span<Token> out) const {
    std::uint32_t count = 0;
    for (std::uint32_t block = first_; block != kNoBlock; block = pool_.block(block).next) {
        for (std::uint32_t n = 0; n < pool_.block(block).words; ++n) {
            if (count == out.size()) return count;
            out[count++] = {pool_.words(block)[n], (pool_.call_bits(block)[n / 64] >> (n % 64) & 1) != 0};
        }
    }
    return count;
}

void TokenStream::set_list(std::uint32_t first, std::uint32_t last, std::uint32_t words) {
    first_ = first;
    last_ = last;
    words_ = words;
    use_.in_use = words;
    use_.high_water = std::max<std::uint64_t>(use_.high_water, words);
}

}  // namespace tedavis::raytrace
