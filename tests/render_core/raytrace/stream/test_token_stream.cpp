#include "render_core/raytrace/stream/token_stream.hpp"

#include "tests/support/raytrace/rewritten_stream.hpp"

namespace tedavis::raytrace::test_token_stream {
namespace {

using test_support::RewrittenStream;
using test_support::stream_settings;
using Tokens = std::vector<Token>;

TEST(TokenStream, HoldsWhatWasAppended) {
    for (const std::uint32_t size : test_support::kBlockSizes) {
        RewrittenStream s(stream_settings(size, 32768));
        Tokens all;
        for (std::uint32_t n = 0; n < 10000; ++n) all.push_back({n * 2654435761u, n % 3 == 1});
        s.append(Tokens(all.begin(), all.begin() + 77));
        s.append(Tokens(all.begin() + 77, all.end()));
        EXPECT_EQ(s.tokens(), all);
        Token few[5];
        EXPECT_EQ(s.stream.read(few), 5u);
        EXPECT_EQ(few[4], all[4]);
        s.stream.clear();
        EXPECT_EQ(s.tokens(), Tokens());
        s.append({literal(1)});
        EXPECT_EQ(s.tokens(), Tokens{literal(1)});
        EXPECT_EQ(s.stream.use().high_water, 10000u);
    }
}

TEST(TokenStream, RefusesWhatDoesNotFitAndCounts) {
    RewrittenStream s(stream_settings(4096, 32768));
    for (int round = 0; round < 3; ++round) {
        s.append(Tokens(32768, literal(5)));
        const Token one = literal(6);
        EXPECT_FALSE(s.stream.try_append({&one, 1}));
        EXPECT_EQ(s.stream.words(), 32768u);
        s.stream.clear();
    }
    EXPECT_EQ(s.stream.use().refused, 3u);
}

std::string_view refusal(const StreamSettings& settings, std::size_t bytes, base::FaultText& kept) {
    std::vector<unsigned char> memory(bytes);
    base::Arena arena(memory.data(), memory.size());
    TokenStream stream;
    const auto answer = stream.start(settings, arena);
    kept = answer.ok() ? base::FaultText() : answer.error();
    return kept.view();
}

TEST(TokenStream, SaysWhatIsWrongWithItsSettings) {
    base::FaultText kept;
    StreamSettings settings;
    settings.block_words = 100;
    EXPECT_EQ(refusal(settings, 100, kept),
              "blocks of a token stream have 64 to 4096 words, a power of two; give block_words such a number");
    settings = {};
    settings.capacity_words = 1000;
    EXPECT_EQ(refusal(settings, 100, kept), "a token stream holds 32768 to 67108864 words; give capacity_words such a number");
    settings = {};
    settings.reserve_words = settings.capacity_words + 1;
    EXPECT_EQ(refusal(settings, 100, kept),
              "the reserve of a token stream is a part of its capacity; give reserve_words a smaller number");
    settings = {};
    settings.most_workers = 65;
    EXPECT_EQ(refusal(settings, 100, kept), "1 to 64 workers rewrite a token stream; give most_workers such a number");
    settings = {};
    EXPECT_EQ(refusal(settings, 100000, kept),
              "the blocks of the token stream do not fit its memory; give more or a smaller capacity_words");
    EXPECT_EQ(refusal(settings, TokenStream::bytes_needed(settings), kept), "");
}

}  // namespace
}  // namespace tedavis::raytrace::test_token_stream
