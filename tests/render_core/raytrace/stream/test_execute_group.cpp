#include "render_core/raytrace/stream/execute_group.hpp"

#include "tests/render_core/raytrace/stream/passes_by_hand.hpp"
#include "tests/render_core/raytrace/stream/stream_program.hpp"

namespace tedavis::raytrace::test_execute_group {
namespace {

using test_support::NumberTasks;
using test_support::PassesByHand;
using Tokens = std::vector<Token>;

/// Calls that give numbers only, single ones and for several, some without their arguments.
Tokens plain_program(const NumberTasks& tasks, std::uint32_t seed) {
    std::mt19937 random(seed);
    const TaskId some[] = {tasks.add, tasks.twice, tasks.turn, tasks.drop};
    Tokens program;
    while (program.size() < 3000) {
        for (std::uint32_t n = random() % 12 == 0 ? 200 : random() % 5; n > 0; --n)
            program.push_back(literal(static_cast<std::uint32_t>(random())));
        program.push_back(call(some[random() % 4], random() % 5 == 0 ? 1 + random() % 90 : 1));
    }
    return program;
}

TEST(ExecuteGroup, ARoundIsWhatPlainSearchFinds) {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        NumberTasks tasks;
        const Tokens program = plain_program(tasks, seed);
        const Tokens expected = test_support::round_by_search(program, tasks.network);
        EXPECT_NE(expected, program);
        for (const std::uint32_t blocks : {1u, 2u, 5u, 1000u}) {
            test_support::RewrittenStream s(test_support::stream_settings(64));
            s.append(program);
            PassesByHand how;
            how.blocks_of_group = blocks;
            EXPECT_EQ(test_support::round_by_hand(s.stream, tasks.network, how), expected) << seed << ' ' << blocks;
        }
    }
}

TEST(ExecuteGroup, PassesThatDoNotSeeOverBordersFail) {
    NumberTasks tasks;
    const Tokens program = plain_program(tasks, 1);
    const Tokens expected = test_support::round_by_search(program, tasks.network);
    test_support::RewrittenStream s(test_support::stream_settings(64));
    s.append(program);
    PassesByHand how;
    how.is_blind = true;
    EXPECT_NE(test_support::round_by_hand(s.stream, tasks.network, how), expected);
    how.blocks_of_group = 1000;  // one group has no borders
    EXPECT_EQ(test_support::round_by_hand(s.stream, tasks.network, how), expected);
}

}  // namespace
}  // namespace tedavis::raytrace::test_execute_group
