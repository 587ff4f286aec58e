#include "render_core/raytrace/stream/stream_rewriter.hpp"

#include "tests/render_core/raytrace/stream/stream_program.hpp"
#include "tests/support/raytrace/rewritten_stream.hpp"
#include "tests/support/raytrace/stream_interpreter.hpp"

namespace tedavis::raytrace::test_stream_rewriter {
namespace {

using test_support::NumberTasks;
using test_support::RewrittenStream;
using test_support::stream_settings;
using test_support::StreamInterpreter;
using Tokens = std::vector<Token>;

TEST(StreamRewriter, GivesWhatPlainRecursionGives) {
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        NumberTasks tasks, expected_tasks;
        const Tokens program = random_program(tasks, seed, 1500);
        const Tokens expected = StreamInterpreter(expected_tasks.network).evaluate(program);
        base::SerialWorkers serial;
        for (const std::uint32_t size : test_support::kBlockSizes) {
            RewrittenStream s(stream_settings(size));
            s.append(program);
            const StreamRewriter::Answer answer = s.rewriter.rewrite(tasks.network, serial, 100000);
            ASSERT_TRUE(answer.ok()) << answer.error().c_str();
            EXPECT_TRUE(answer.value().is_finished);
            EXPECT_EQ(s.tokens(), expected) << seed << ' ' << size;
            EXPECT_EQ(tasks.marks, expected_tasks.marks);
        }
    }
}

/// Streams after every round, one behind the other; "add" becomes a difference after the third.
std::vector<Tokens> rounds_of(const Tokens& program, std::uint32_t size, base::Workers& workers,
                              std::vector<std::uint32_t>& marks) {
    NumberTasks tasks;
    RewrittenStream s(stream_settings(size, 1 << 16));
    s.append(program);
    std::vector<Tokens> rounds;
    for (std::uint32_t round = 0; round < 5000; ++round) {
        if (round == 3) {
            EXPECT_TRUE(tasks.network.replace(tasks.add, tasks.difference()).ok());
        }
        const StreamRewriter::Answer answer = s.rewriter.rewrite(tasks.network, workers, 1);
        rounds.push_back(s.tokens());
        if (!answer.ok() || answer.value().is_finished) break;
    }
    marks = tasks.marks;
    return rounds;
}

TEST(StreamRewriter, EveryRoundIsTheSameForAllWorkersAndBlockSizes) {
    for (std::uint32_t seed = 21; seed <= 22; ++seed) {
        const Tokens program = random_program(NumberTasks(), seed, 3000);
        base::SerialWorkers serial;
        std::vector<std::uint32_t> expected_marks, marks;
        const std::vector<Tokens> expected = rounds_of(program, 512, serial, expected_marks);
        EXPECT_GT(expected.size(), 5u);
        for (const std::uint32_t count : test_support::kWorkerCounts) {
            const std::unique_ptr<base::Workers> workers = test_support::make_workers(count);
            for (const std::uint32_t size : test_support::kBlockSizes) {
                EXPECT_EQ(rounds_of(program, size, *workers, marks), expected) << seed << ' ' << count << ' ' << size;
                EXPECT_EQ(marks, expected_marks);
            }
        }
    }
}

TEST(StreamRewriter, Fibonacci) {
    NumberTasks tasks;
    base::SerialWorkers workers;
    RewrittenStream s(stream_settings(64));
    s.append({literal(19), call(tasks.fibonacci)});
    const StreamRewriter::Answer answer = s.rewriter.rewrite(tasks.network, workers, 1000);
    ASSERT_TRUE(answer.ok()) << answer.error().c_str();
    EXPECT_TRUE(answer.value().is_finished);
    EXPECT_EQ(s.tokens(), Tokens{literal(4181)});
    // 13529 calls, 6764 sums; depth first there would be one call a round.
    EXPECT_EQ(answer.value().counts.calls, 13529u + 6764u);
    EXPECT_LE(answer.value().rounds, 60u);
    EXPECT_EQ(s.stream.use().in_use, 1u);
    EXPECT_GT(s.stream.use().high_water, 1000u);
}

TEST(StreamRewriter, KernelsAreFull) {
    NumberTasks tasks;
    base::SerialWorkers workers;
    RewrittenStream s(stream_settings(512));
    Tokens program;
    for (std::uint32_t n = 0; n < 20000; ++n)
        for (const Token& token : {literal(n), literal(1), call(n % 2 == 0 ? tasks.add : tasks.turn)}) program.push_back(token);
    s.append(program);
    const StreamRewriter::Answer answer = s.rewriter.rewrite(tasks.network, workers, 1);
    ASSERT_TRUE(answer.ok());
    EXPECT_EQ(answer.value().counts.calls, 20000u);
    EXPECT_GT(20000.0 / static_cast<double>(answer.value().counts.lanes), 0.97);
}

TEST(StreamRewriter, WaitsForRoomAndEnds) {
    for (const std::uint32_t size : test_support::kBlockSizes) {
        NumberTasks tasks;
        base::SerialWorkers workers;
        RewrittenStream s(stream_settings(size, 32768));
        Tokens program;
        for (std::uint32_t n = 0; n < 300; ++n)
            for (const Token& token : {literal(14), call(tasks.fibonacci), call(tasks.drop)}) program.push_back(token);
        s.append(program);
        const StreamRewriter::Answer answer = s.rewriter.rewrite(tasks.network, workers, 1000000);
        ASSERT_TRUE(answer.ok()) << answer.error().c_str();
        EXPECT_TRUE(answer.value().is_finished);
        EXPECT_GT(answer.value().waits, 0u);
        EXPECT_EQ(s.stream.words(), 0u);
        EXPECT_EQ(s.stream.use().refused, answer.value().waits);
        EXPECT_LE(s.stream.use().high_water, 32768u);
    }
}

TEST(StreamRewriter, SaysWhyItCannotGoOn) {
    NumberTasks tasks;
    base::SerialWorkers workers;
    RewrittenStream s(stream_settings(64, 32768));
    s.append({literal(1), call(tasks.add), literal(2)});
    StreamRewriter::Answer answer = s.rewriter.rewrite(tasks.network, workers, 10);
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.error().view(),
              "the token stream cannot go on: 'add' lacks arguments: 1 of 2 are there; put before it what gives them");
    s.stream.clear();
    s.append({call(40)});
    answer = s.rewriter.rewrite(tasks.network, workers, 10);
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.error().view(),
              "the token stream calls task 40, which is not there, or too often at once; add it, or call it less often at once");
    s.stream.clear();
    s.append(Tokens(32760, literal(7)));
    s.append({literal(40), literal(1), call(tasks.spread)});
    answer = s.rewriter.rewrite(tasks.network, workers, 10);
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.error().view(),
              "the token stream cannot go on: 'spread' has no room: 32763 of 32768 words are taken; give capacity_words more");
}

void give_two(void*, const Batch&, TokenWriter& out) {
    out.literal(1);
    out.literal(2);
    out.done();
}

TEST(StreamRewriter, ATaskThatGivesTooMuchIsNamed) {
    NumberTasks tasks;
    base::SerialWorkers workers;
    RewrittenStream s(stream_settings(64, 32768));
    Task task = tasks.network.task(tasks.drop);
    task.run = give_two;
    task.most_outputs = 1;
    ASSERT_TRUE(tasks.network.replace(tasks.drop, task).ok());
    s.append({literal(1), call(tasks.drop)});
    const StreamRewriter::Answer answer = s.rewriter.rewrite(tasks.network, workers, 10);
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.error().view(), "task 3 of a token stream gave more than its most_outputs; state more");
}

TEST(StreamRewriter, TokensMayBeAddedWhileItRuns) {
    NumberTasks tasks;
    base::SerialWorkers workers;
    RewrittenStream s(stream_settings(64, 32768));
    s.append({literal(10), call(tasks.fibonacci)});
    ASSERT_TRUE(s.rewriter.rewrite(tasks.network, workers, 3).ok());
    s.append({literal(5), call(tasks.add)});
    ASSERT_TRUE(s.rewriter.rewrite(tasks.network, workers, 1000).ok());
    EXPECT_EQ(s.tokens(), Tokens{literal(60)});
}

}  // namespace
}  // namespace tedavis::raytrace::test_stream_rewriter
