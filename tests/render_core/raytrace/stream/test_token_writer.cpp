#include "render_core/raytrace/stream/token_writer.hpp"

#include <gtest/gtest.h>

#include "tests/render_core/raytrace/stream/stream_program.hpp"

namespace tedavis::raytrace::test_token_writer {
namespace {

using test_support::NumberTasks;
using Tokens = std::vector<Token>;

struct Output {
    NumberTasks tasks;
    std::vector<std::uint32_t> words;
    std::vector<std::uint16_t> places;
    std::vector<WrittenRun> runs;
    std::vector<std::uint32_t> borders;
    TokenWriter out;

    explicit Output(std::vector<std::uint32_t> calls, std::uint32_t most = 100, std::size_t room = 200)
        : words(room), places(room), runs(calls.size()), out(tasks.network, {words.data(), room}, {places.data(), room}) {
        std::uint32_t all = 0;
        for (const std::uint32_t count : calls) borders.push_back(all += count);
        out.begin({borders.data(), borders.size()}, runs.data(), most);
    }
    Tokens run(std::size_t n) const {
        Tokens tokens;
        for (std::uint32_t w = 0; w < runs[n].words; ++w) tokens.push_back({words[runs[n].first_word + w], false});
        for (std::uint32_t c = 0; c < runs[n].calls; ++c)
            tokens[places[runs[n].first_call + c] - runs[n].first_word].is_call = true;
        return tokens;
    }
};

TEST(TokenWriter, CallsOfOneTaskBecomeOneToken) {
    Output o({3});
    for (std::uint32_t n = 0; n < 3; ++n) {
        o.out.literal(n);
        o.out.literal(10 + n);
        o.out.call(o.tasks.add);
        o.out.done();
    }
    o.out.finish();
    EXPECT_EQ(o.run(0),
              (Tokens{literal(0), literal(10), literal(1), literal(11), literal(2), literal(12), call(o.tasks.add, 3)}));
    EXPECT_EQ(o.out.fault(), WriterFault::none);
}

TEST(TokenWriter, OtherCallsAndNumbersBetweenThemKeepTheirPlace) {
    Output o({1});
    o.out.literal(1);
    o.out.literal(2);
    o.out.call(o.tasks.add);
    o.out.literal(3);
    o.out.call(o.tasks.add);  // with what the first gives: one word is missing for a common token
    o.out.call(o.tasks.twice);
    o.out.literal(4);
    o.out.finish();
    EXPECT_EQ(o.out.fault(), WriterFault::nobody);
    EXPECT_EQ(o.run(0), (Tokens{literal(1), literal(2), call(o.tasks.add), literal(3), call(o.tasks.add), call(o.tasks.twice),
                                literal(4)}));
}

TEST(TokenWriter, RunsEndWhereTheirCallsEnd) {
    Output o({2, 1, 3});
    const std::uint32_t records[] = {0, 1, 2, 3, 4, 5};
    o.out.each_calls(o.tasks.twice, records, 6);
    o.out.finish();
    EXPECT_EQ(o.run(0), (Tokens{literal(0), literal(1), call(o.tasks.twice, 2)}));
    EXPECT_EQ(o.run(1), (Tokens{literal(2), call(o.tasks.twice)}));
    EXPECT_EQ(o.run(2), (Tokens{literal(3), literal(4), literal(5), call(o.tasks.twice, 3)}));
    EXPECT_EQ(o.out.fault(), WriterFault::none);
}

TEST(TokenWriter, ATokenStandsForNoMoreThanMayBe) {
    Output o({1}, 16000, 16384);
    ASSERT_EQ(o.tasks.network.most_count(o.tasks.add), 2047u);
    const std::vector<std::uint32_t> records(2 * 3000, 5);
    o.out.calls(o.tasks.add, records.data(), 3000);
    o.out.done();
    o.out.finish();
    const Tokens tokens = o.run(0);
    ASSERT_EQ(tokens.size(), 6002u);
    EXPECT_EQ(tokens[4094], call(o.tasks.add, 2047));
    EXPECT_EQ(tokens.back(), call(o.tasks.add, 953));
}

struct TEDAVIS_RECORD Pair {
    std::uint32_t a, b;
};

TEST(TokenWriter, RecordsMayBeWrittenWhereTheyGo) {
    Output in_place({2}, 100, 50), copied({2}, 100, 50);
    for (const std::uint32_t count : {3u, 0u, 2u}) {
        Pair pairs[3] = {{1, 2}, {3, 4}, {5, count}};
        Pair* place = in_place.out.calls_in_place<Pair>(in_place.tasks.add, count);
        ASSERT_NE(place, nullptr);
        std::copy(pairs, pairs + count, place);
        copied.out.calls(copied.tasks.add, pairs, count);
        if (count != 3) continue;
        in_place.out.literal(9);
        copied.out.literal(9);
    }
    in_place.out.done(2);
    copied.out.done(2);
    EXPECT_EQ(in_place.run(0), copied.run(0));
    EXPECT_EQ(in_place.run(0).size(), 6u + 1 + 1 + 4 + 1);
    EXPECT_EQ(in_place.out.calls_in_place<Pair>(in_place.tasks.add, 40), nullptr);
    EXPECT_EQ(in_place.out.fault(), WriterFault::too_much);
    EXPECT_EQ(copied.out.calls_in_place<Pair>(50, 1), nullptr);
    EXPECT_EQ(copied.out.fault(), WriterFault::unknown_task);
}

TEST(TokenWriter, TellsWhatIsLeftOfARun) {
    Output o({2, 3});
    EXPECT_EQ(o.out.together(), 2u);
    o.out.done();
    EXPECT_EQ(o.out.together(), 1u);
    o.out.done(1);
    EXPECT_EQ(o.out.together(), 3u);
    o.out.literal(9);
    o.out.done(3);
    o.out.finish();
    EXPECT_EQ(o.run(0), Tokens{});
    EXPECT_EQ(o.run(1), Tokens{literal(9)});
}

TEST(TokenWriter, NotesFaultsAndLeavesThemOut) {
    Output too_much({1, 1}, 2);
    for (std::uint32_t n = 0; n < 3; ++n) too_much.out.literal(n);
    too_much.out.done();
    too_much.out.literal(7);
    too_much.out.done();
    too_much.out.finish();
    EXPECT_EQ(too_much.out.fault(), WriterFault::too_much);
    EXPECT_EQ(too_much.run(0), Tokens{});
    EXPECT_EQ(too_much.run(1), Tokens{literal(7)});

    Output full({1}, 1000, 8);
    const std::uint32_t records[20] = {};
    full.out.calls(full.tasks.add, records, 10);
    full.out.literals(records, 20);
    for (std::uint32_t n = 0; n < 20; ++n) {
        full.out.literal(n);
        full.out.call(full.tasks.twice);
    }
    full.out.done();
    full.out.finish();
    EXPECT_EQ(full.out.fault(), WriterFault::too_much);

    Output unknown({1});
    unknown.out.call(50);
    EXPECT_EQ(unknown.out.fault(), WriterFault::unknown_task);
    Output nobody({2});
    nobody.out.literal(1);
    nobody.out.finish();
    EXPECT_EQ(nobody.out.fault(), WriterFault::nobody);
    Output too_many({2, 3});
    too_many.out.done(3);
    EXPECT_EQ(too_many.out.fault(), WriterFault::nobody);
}

}  // namespace
}  // namespace tedavis::raytrace::test_token_writer
