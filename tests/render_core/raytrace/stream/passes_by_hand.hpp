/// One round of a token stream by its three passes, over groups of any size, and the same by plain search.
#pragma once

#include <vector>

#include "render_core/raytrace/stream/decode_group.hpp"
#include "render_core/raytrace/stream/execute_group.hpp"
#include "tests/support/raytrace/rewritten_stream.hpp"
#include "tests/support/raytrace/stream_interpreter.hpp"

namespace tedavis::test_support {

struct PassesByHand {
    std::uint32_t blocks_of_group = 1;
    raytrace::RoundRoom room = {1 << 20, 1 << 20};
    bool is_blind = false;  ///< to what spans groups: the fault that the tests must see
};

inline std::vector<raytrace::BlockGroup> groups_of(const raytrace::TokenStream& stream, std::uint32_t blocks_of_group) {
    std::vector<raytrace::BlockGroup> groups;
    for (std::uint32_t id = stream.first_block(); id != raytrace::kNoBlock; id = stream.pool().block(id).next) {
        if (groups.empty() || groups.back().blocks == blocks_of_group) {
            groups.emplace_back();
            groups.back().first_block = id;
        }
        raytrace::BlockGroup& group = groups.back();
        group.last_block = id;
        ++group.blocks;
        group.words += stream.pool().block(id).words;
        group.calls += stream.pool().block(id).calls;
    }
    return groups;
}

inline void append_blocks(const raytrace::BlockPool& pool, std::uint32_t first, std::uint32_t blocks,
                          std::vector<raytrace::Token>& out) {
    for (std::uint32_t n = 0, id = first; n < blocks; ++n, id = pool.block(id).next)
        for (std::uint32_t w = 0; w < pool.block(id).words; ++w)
            out.push_back({pool.words(id)[w], (pool.call_bits(id)[w / 64] >> (w % 64) & 1) != 0});
}

/// What the stream would be after a round; it is left as it is, and the pool has fewer free blocks.
inline std::vector<raytrace::Token> round_by_hand(raytrace::TokenStream& stream, const raytrace::TaskNetwork& network,
                                                  const PassesByHand& how) {
    std::vector<raytrace::BlockGroup> groups = groups_of(stream, how.blocks_of_group);
    const base::Span<raytrace::BlockGroup> all(groups.data(), groups.size());
    for (raytrace::BlockGroup& group : groups) {
        raytrace::decode_group(stream.pool(), network, group);
        if (how.is_blind) (void)raytrace::allocate_round({&group, 1}, network, how.room);
    }
    if (!how.is_blind) (void)raytrace::allocate_round(all, network, how.room);
    raytrace::give_blocks(all, how.room, {}, stream.pool());
    std::vector<unsigned char> memory(raytrace::Segment::bytes_needed());
    base::Arena arena(memory.data(), memory.size());
    raytrace::Segment segment;
    EXPECT_TRUE(segment.start(arena));
    std::vector<raytrace::Token> tokens;
    for (raytrace::BlockGroup& group : groups) {
        if (group.is_rewritten) raytrace::execute_group(all, group, network, how.room, stream.pool(), segment);
        const std::uint32_t first = group.is_rewritten ? group.new_first : group.first_block;
        append_blocks(stream.pool(), first, group.is_rewritten ? group.new_blocks : group.blocks, tokens);
    }
    return tokens;
}

/// Every call that has its arguments, each by itself. For tasks that give no calls.
inline std::vector<raytrace::Token> round_by_search(const std::vector<raytrace::Token>& program,
                                                    const raytrace::TaskNetwork& network) {
    std::vector<raytrace::Token> out;
    std::size_t literals = 0;
    for (const raytrace::Token& token : program) {
        const raytrace::CallShape shape = token.is_call ? network.shape(token.word) : raytrace::CallShape();
        if (!token.is_call || !shape.is_known || literals < shape.arguments) {
            literals = token.is_call ? 0 : literals + 1;
            out.push_back(token);
            continue;
        }
        std::vector<raytrace::Token> pattern(out.end() - shape.arguments, out.end());
        pattern.push_back(token);
        out.resize(out.size() - shape.arguments);
        for (const raytrace::Token& given : StreamInterpreter(network).evaluate(pattern)) out.push_back(given);
        literals = 0;
    }
    return out;
}

}  // namespace tedavis::test_support
