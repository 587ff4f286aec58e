#include "render_core/raytrace/stream/allocate_round.hpp"

#include "tests/render_core/raytrace/stream/passes_by_hand.hpp"
#include "tests/render_core/raytrace/stream/stream_program.hpp"

namespace tedavis::raytrace::test_allocate_round {
namespace {

using test_support::NumberTasks;
using test_support::PassesByHand;
using Tokens = std::vector<Token>;

std::vector<BlockGroup> allocated(test_support::RewrittenStream& s, const TaskNetwork& network, const RoundRoom& room,
                                  bool& all) {
    std::vector<BlockGroup> groups = test_support::groups_of(s.stream, 1);
    for (BlockGroup& group : groups) decode_group(s.stream.pool(), network, group);
    all = allocate_round({groups.data(), groups.size()}, network, room);
    return groups;
}

TEST(AllocateRound, WordsAreLentOverSeveralGroups) {
    NumberTasks tasks;
    test_support::RewrittenStream s(test_support::stream_settings(64, 32768));
    Tokens program(200, literal(1));  // three blocks of numbers and eight words of the fourth
    program.push_back(call(tasks.add, 75));
    s.append(program);
    bool all = false;
    const std::vector<BlockGroup> groups = allocated(s, tasks.network, {1000, 1000}, all);
    ASSERT_EQ(groups.size(), 4u);
    EXPECT_TRUE(all);
    EXPECT_TRUE(groups[3].first_runs);
    EXPECT_EQ(groups[3].borrowed, 142u);
    EXPECT_EQ(groups[2].lent, 64u);
    EXPECT_EQ(groups[1].lent, 64u);
    EXPECT_EQ(groups[0].lent, 14u);
    EXPECT_EQ(groups[3].lender, 0u);
    EXPECT_EQ(groups[3].lender_offset, 50u);
}

TEST(AllocateRound, TheFirstMayUseTheReserveAndTheRestWaits) {
    NumberTasks tasks;
    test_support::RewrittenStream s(test_support::stream_settings(64));
    Tokens program;
    for (int n = 0; n < 100; ++n)
        for (const Token& token : {literal(40), literal(1), call(tasks.spread)}) program.push_back(token);
    s.append(program);
    const std::uint64_t growth = tasks.network.shape(call_word(tasks.spread)).growth;
    for (const std::uint32_t fitting : {0u, 1u, 7u, 60u}) {
        std::uint32_t executed = 0;
        bool is_front = true;
        const RoundRoom room = {fitting * growth, growth};
        const Tokens after = test_support::round_by_hand(s.stream, tasks.network, {1, room, false});
        const Tokens in_large_groups = test_support::round_by_hand(s.stream, tasks.network, {3, room, false});
        EXPECT_EQ(after, in_large_groups);
        for (std::size_t n = 0; n + 2 < after.size();) {
            const bool waits = after[n + 2] == call(tasks.spread);
            executed += waits ? 0 : 40;
            EXPECT_TRUE(is_front || waits);
            is_front = is_front && !waits;
            n += waits ? 3 : 40;  // sums of what the spread gave
        }
        EXPECT_EQ(executed, 40 * std::max(1u, fitting));
    }
    bool all = true;
    (void)allocated(s, tasks.network, {7 * growth, growth}, all);
    EXPECT_FALSE(all);
    (void)allocated(s, tasks.network, {100 * growth, growth}, all);
    EXPECT_TRUE(all);
    EXPECT_EQ(test_support::round_by_hand(s.stream, tasks.network, {1, {0, growth - 1}, false}), program);
}

TEST(AllocateRound, WithoutLendingCallsAreLost) {
    NumberTasks tasks;
    test_support::RewrittenStream s(test_support::stream_settings(64));
    const Tokens program = test_support::random_program(tasks, 3, 2000);
    s.append(program);
    PassesByHand how;
    const Tokens right = test_support::round_by_hand(s.stream, tasks.network, how);
    how.is_blind = true;
    EXPECT_NE(test_support::round_by_hand(s.stream, tasks.network, how), right);
}

}  // namespace
}  // namespace tedavis::raytrace::test_allocate_round
