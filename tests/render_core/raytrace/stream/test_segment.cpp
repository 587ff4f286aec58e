#include "render_core/raytrace/stream/segment.hpp"

#include "tests/render_core/raytrace/stream/stream_program.hpp"
#include "tests/support/raytrace/rewritten_stream.hpp"

namespace tedavis::raytrace::test_segment {
namespace {

using test_support::NumberTasks;
using Tokens = std::vector<Token>;

/// Notes its batches and gives the second word.
struct BatchNotes {
    std::vector<std::uint32_t> counts;
    std::vector<const std::uint32_t*> places;

    static void run(void* self, const Batch& batch, TokenWriter& out) {
        static_cast<BatchNotes*>(self)->counts.push_back(batch.count);
        static_cast<BatchNotes*>(self)->places.push_back(batch.arguments);
        for (std::uint32_t n = 0; n < batch.count; ++n) {
            out.literal(batch.record(n)[1]);
            out.done();
        }
    }
};

struct NotedStream {
    NumberTasks tasks;
    BatchNotes notes;
    base::SerialWorkers workers;
    test_support::RewrittenStream s{test_support::stream_settings(512)};

    NotedStream() {
        Task task = tasks.network.task(tasks.add);
        task.run = BatchNotes::run;
        task.context = &notes;
        EXPECT_TRUE(tasks.network.replace(tasks.add, task).ok());
    }
    void rewrite_once(const Tokens& program) {
        s.append(program);
        EXPECT_TRUE(s.rewriter.rewrite(tasks.network, workers, 1).ok());
    }
};

TEST(Segment, SingleCallsBecomeOneBatchAndTheirResultsGoHome) {
    NotedStream n;
    Tokens program, expected;
    for (std::uint32_t i = 0; i < 50; ++i) {
        const TaskId task = i % 3 == 0 ? n.tasks.turn : n.tasks.add;
        for (const Token& token : {literal(1000 + i), literal(i), call(task)}) program.push_back(token);
        expected.push_back(literal(i));
        if (i % 3 == 0) expected.push_back(literal(1000 + i));
    }
    n.rewrite_once(program);
    EXPECT_EQ(n.notes.counts, std::vector<std::uint32_t>{33});
    EXPECT_EQ(n.s.tokens(), expected);
}

TEST(Segment, CallsThatFillTheKernelAreHandedOnWhereTheyLie) {
    NotedStream n;
    Tokens program;
    for (const std::uint32_t calls : {16u, 5u, 64u, 6u, 70u}) {
        for (std::uint32_t word = 0; word < 2 * calls; ++word) program.push_back(literal(word));
        program.push_back(call(n.tasks.add, calls));
    }
    n.s.append(program);
    const std::uint32_t* words = n.s.stream.pool().words(n.s.stream.first_block());
    EXPECT_TRUE(n.s.rewriter.rewrite(n.tasks.network, n.workers, 1).ok());
    EXPECT_EQ(n.notes.counts, (std::vector<std::uint32_t>{16, 64, 70, 11}));
    EXPECT_EQ(n.notes.places[0], words);
    EXPECT_EQ(n.notes.places[1], words + 33 + 11);
    EXPECT_EQ(n.s.stream.words(), 16u + 5 + 64 + 6 + 70);
}

TEST(Segment, CallsThatLeaveMuchForOthersRunInSmallParts) {
    NotedStream n;
    Task task = n.tasks.network.task(n.tasks.add);
    task.left_words = 1000;
    ASSERT_TRUE(n.tasks.network.replace(n.tasks.add, task).ok());
    Tokens program, expected;
    for (std::uint32_t i = 0; i < 50; ++i) {
        for (const Token& token : {literal(1000 + i), literal(i), call(n.tasks.add)}) program.push_back(token);
        expected.push_back(literal(i));
    }
    n.rewrite_once(program);
    EXPECT_EQ(n.notes.counts, (std::vector<std::uint32_t>{8, 8, 8, 8, 8, 8, 2}));  // of 8192 words together
    EXPECT_EQ(n.s.tokens(), expected);
}

TEST(Segment, FewCallsThatNeedNoRoomGoOnInTheSameRound) {
    NotedStream n;
    n.rewrite_once({literal(30), literal(7), call(n.tasks.spread)});  // 30 sums in one token
    EXPECT_EQ(n.s.tokens(), Tokens(30, literal(7)));
    n.s.stream.clear();
    n.rewrite_once({literal(3), call(n.tasks.fibonacci)});  // the sum lacks arguments, what comes before it lengthens the stream
    EXPECT_EQ(n.s.tokens(), (Tokens{literal(2), literal(1), call(n.tasks.fibonacci, 2), call(n.tasks.add)}));
}

TEST(Segment, ManyCallsAtOnceAreDoneInParts) {
    NotedStream n;
    Tokens program, expected;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        for (const Token& token : {literal(40), literal(i), call(n.tasks.spread)}) program.push_back(token);
        expected.insert(expected.end(), 40, literal(i));
    }
    n.s.append(program);
    while (!n.s.rewriter.rewrite(n.tasks.network, n.workers, 100).value().is_finished) {
    }
    EXPECT_EQ(n.s.tokens(), expected);
}

}  // namespace
}  // namespace tedavis::raytrace::test_segment
