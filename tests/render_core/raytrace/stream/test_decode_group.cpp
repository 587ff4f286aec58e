#include "render_core/raytrace/stream/decode_group.hpp"

#include "tests/render_core/raytrace/stream/passes_by_hand.hpp"
#include "tests/render_core/raytrace/stream/stream_program.hpp"

namespace tedavis::raytrace::test_decode_group {
namespace {

using test_support::NumberTasks;
using Tokens = std::vector<Token>;

TEST(DecodeGroup, SaysWhatAGroupHolds) {
    NumberTasks tasks;
    test_support::RewrittenStream s(test_support::stream_settings(64, 32768));
    s.append({literal(1), call(tasks.add), literal(9), literal(3), literal(4), call(tasks.spread), literal(6), call(tasks.spread),
              literal(1), literal(2), call(tasks.add), literal(5), literal(6)});
    BlockGroup group = test_support::groups_of(s.stream, 1)[0];
    decode_group(s.stream.pool(), tasks.network, group);
    EXPECT_EQ(group.before_first, 1u);
    EXPECT_EQ(group.first_call, call_word(tasks.add));
    EXPECT_EQ(group.behind_last, 2u);
    EXPECT_EQ(group.growth, 120u - 3);  // of the spread that has its arguments
    EXPECT_EQ(group.first_growth, 120u - 3);
    EXPECT_TRUE(group.runs_steady);
}

TEST(DecodeGroup, GroupsAddUpToTheWhole) {
    NumberTasks tasks;
    const Tokens program = test_support::random_program(tasks, 5, 4000);
    test_support::RewrittenStream s(test_support::stream_settings(64));
    s.append(program);
    std::uint64_t expected = 0;
    std::uint32_t literals = 0;
    for (const Token& token : program) {
        if (token.is_call && tasks.network.shape(token.word).arguments <= literals)
            expected += tasks.network.shape(token.word).growth;
        literals = token.is_call ? 0 : literals + 1;
    }
    BlockGroup whole = test_support::groups_of(s.stream, 100000)[0];
    decode_group(s.stream.pool(), tasks.network, whole);
    const std::uint64_t of_first = tasks.network.shape(whole.first_call).growth;
    EXPECT_EQ(whole.growth + of_first, expected);
    // By the groups alone, calls that begin in a group before are missing: that is what allocate is for.
    std::uint64_t inside = 0;
    for (BlockGroup& group : test_support::groups_of(s.stream, 1)) {
        decode_group(s.stream.pool(), tasks.network, group);
        inside += group.growth;
    }
    EXPECT_LT(inside, expected);
    EXPECT_GT(inside, 0u);
}

TEST(DecodeGroup, AGroupOfNumbersIsAllBehindTheLastCall) {
    NumberTasks tasks;
    test_support::RewrittenStream s(test_support::stream_settings(64, 32768));
    s.append(Tokens(150, literal(8)));
    BlockGroup group = test_support::groups_of(s.stream, 3)[0];
    decode_group(s.stream.pool(), tasks.network, group);
    EXPECT_EQ(group.calls, 0u);
    EXPECT_EQ(group.behind_last, 150u);
    EXPECT_FALSE(group.runs_steady);
}

}  // namespace
}  // namespace tedavis::raytrace::test_decode_group
