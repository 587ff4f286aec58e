/// A token stream with its memory and its rewriter, and workers, for tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "platform/threads/thread_workers.hpp"
#include "render_core/raytrace/stream/stream_rewriter.hpp"

namespace tedavis::test_support {

inline constexpr std::uint32_t kWorkerCounts[] = {1, 2, 3, 7};
inline constexpr std::uint32_t kBlockSizes[] = {64, 512, 4096};

inline std::unique_ptr<base::Workers> make_workers(std::uint32_t count) {
    return std::move(platform::make_thread_workers({count, nullptr}).value());
}

inline raytrace::StreamSettings stream_settings(std::uint32_t block_words, std::uint32_t capacity_words = 1 << 18) {
    raytrace::StreamSettings settings;
    settings.block_words = block_words;
    settings.capacity_words = capacity_words;
    settings.reserve_words = std::min(settings.reserve_words, capacity_words / 2);
    return settings;
}

class RewrittenStream {
public:
    explicit RewrittenStream(const raytrace::StreamSettings& settings)
        : memory_(raytrace::TokenStream::bytes_needed(settings) + raytrace::StreamRewriter::bytes_needed(settings)) {
        base::Arena arena(memory_.data(), memory_.size());
        EXPECT_TRUE(stream.start(settings, arena).ok());
        EXPECT_TRUE(rewriter.start(stream, arena).ok());
        EXPECT_EQ(arena.use().refused, 0u);
    }
    RewrittenStream(const RewrittenStream&) = delete;

    void append(const std::vector<raytrace::Token>& tokens) { EXPECT_TRUE(stream.try_append({tokens.data(), tokens.size()})); }
    std::vector<raytrace::Token> tokens() const {
        std::vector<raytrace::Token> all(stream.words());
        EXPECT_EQ(stream.read({all.data(), all.size()}), all.size());
        return all;
    }

    raytrace::TokenStream stream;
    raytrace::StreamRewriter rewriter;

private:
    std::vector<unsigned char> memory_;
};

}  // namespace tedavis::test_support
