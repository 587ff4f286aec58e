#include "render_core/raytrace/stream/task_network.hpp"

#include "tests/render_core/raytrace/stream/stream_program.hpp"
#include "tests/support/raytrace/rewritten_stream.hpp"

namespace tedavis::raytrace::test_task_network {
namespace {

using test_support::NumberTasks;
using Tokens = std::vector<Token>;

Tokens evaluated(const TaskNetwork& network, const Tokens& program) {
    test_support::RewrittenStream s(test_support::stream_settings(64, 32768));
    base::SerialWorkers workers;
    s.append(program);
    EXPECT_TRUE(s.rewriter.rewrite(network, workers, 1000).ok());
    return s.tokens();
}

TEST(TaskNetwork, ShapesFollowTheLimits) {
    NumberTasks tasks;
    EXPECT_EQ(tasks.network.most_count(tasks.add), 2047u);    // 4095 words of arguments
    EXPECT_EQ(tasks.network.most_count(tasks.spread), 136u);  // 16384 of 120 tokens
    EXPECT_EQ(tasks.network.shape(call_word(tasks.spread, 2)).growth, 2 * 120u - 4 - 1);
    EXPECT_EQ(tasks.network.shape(call_word(tasks.add, 2047)).growth, 0u);
    EXPECT_FALSE(tasks.network.shape(call_word(tasks.add, 2048)).is_known);
    EXPECT_FALSE(tasks.network.shape(call_word(tasks.add, 0)).is_known);
    EXPECT_FALSE(tasks.network.shape(call_word(63)).is_known);
}

TEST(TaskNetwork, RefusesInOneSentence) {
    NumberTasks tasks;
    Task task = tasks.network.task(tasks.add);
    task.run = nullptr;
    EXPECT_EQ(tasks.network.add(task).error().view(), "task 'add' has no function; give it one");
    task = tasks.network.task(tasks.add);
    task.lanes = 0;
    EXPECT_EQ(tasks.network.add(task).error().view(), "task 'add' has 0 lanes; give it 1 or more");
    task.lanes = 1;
    task.arguments = 4096;
    EXPECT_FALSE(tasks.network.add(task).ok());
    task.arguments = 3;
    EXPECT_EQ(tasks.network.replace(tasks.add, task).error().view(),
              "task 'add' takes another number of words than what it replaces; add it instead");
    task.arguments = 2;
    task.most_outputs = 9;
    EXPECT_FALSE(tasks.network.replace(tasks.add, task).ok());
    EXPECT_FALSE(tasks.network.replace(60, task).ok());
    EXPECT_FALSE(tasks.network.remove(60).ok());
    EXPECT_FALSE(tasks.network.set_next(tasks.add, 60).ok());
    while (tasks.network.size() < kMaxTasks) ASSERT_TRUE(tasks.network.add(task).ok());
    EXPECT_FALSE(tasks.network.add(task).ok());
    EXPECT_FALSE(tasks.network.insert(tasks.add, task).ok());
    EXPECT_EQ(tasks.network.task(tasks.add).most_outputs, 1u);  // as it was
}

TEST(TaskNetwork, CallsOfWhatIsReplacedAreDoneTheNewWay) {
    NumberTasks tasks;
    const Tokens program = {literal(7), literal(2), call(tasks.add)};
    EXPECT_EQ(evaluated(tasks.network, program), Tokens{literal(9)});
    ASSERT_TRUE(tasks.network.replace(tasks.add, tasks.difference()).ok());
    EXPECT_EQ(evaluated(tasks.network, program), Tokens{literal(5)});
}

/// Adds a hundred to the second word and hands both on.
void pass_on_raised(void*, const Batch& batch, TokenWriter& out) {
    for (std::uint32_t n = 0; n < batch.count; ++n) {
        out.literal(batch.record(n)[0]);
        out.literal(batch.record(n)[1] + 100);
        out.call(batch.next);
        out.done();
    }
}

TEST(TaskNetwork, WhatIsInsertedComesBeforeAndCanBeRemoved) {
    NumberTasks tasks;
    const Tokens program = {literal(7), literal(2), call(tasks.add)};
    Task raised;
    raised.name = "raised";
    raised.arguments = 2;
    raised.most_outputs = 3;
    raised.run = pass_on_raised;
    const TaskNetwork::Answer moved = tasks.network.insert(tasks.add, raised);
    ASSERT_TRUE(moved.ok());
    EXPECT_EQ(tasks.network.task(moved.value()).name.view(), "add");
    EXPECT_EQ(evaluated(tasks.network, program), Tokens{literal(109)});
    ASSERT_TRUE(tasks.network.remove(tasks.add).ok());
    EXPECT_EQ(evaluated(tasks.network, program), Tokens{literal(9)});
    ASSERT_TRUE(tasks.network.remove(moved.value()).ok());  // has no next
    EXPECT_EQ(evaluated(tasks.network, program), Tokens{});
}

}  // namespace
}  // namespace tedavis::raytrace::test_task_network
