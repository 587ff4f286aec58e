#include "render_core/raytrace/stream/range_task.hpp"

#include "tests/render_core/raytrace/stream/stream_program.hpp"
#include "tests/support/raytrace/rewritten_stream.hpp"

namespace tedavis::raytrace::test_range_task {
namespace {

/// Counts each number of the ranges it is given.
struct Visits {
    std::vector<std::uint32_t> count = std::vector<std::uint32_t>(100000);
    std::uint32_t widest = 0;

    static void run(void* self, const Batch& batch, TokenWriter&) {
        Visits& visits = *static_cast<Visits*>(self);
        for (std::uint32_t n = 0; n < batch.count; ++n) {
            const std::uint32_t first = batch.record(n)[0], end = batch.record(n)[1];
            visits.widest = std::max(visits.widest, end - first);
            for (std::uint32_t at = first; at < end; ++at) ++visits.count[at];
        }
    }
};

TEST(RangeTask, EveryNumberComesOnce) {
    for (const RangeSteps& given : {RangeSteps{1, 1}, RangeSteps{7, 10}, RangeSteps{1, 4096}, RangeSteps{1000, 3}}) {
        Visits visits;
        TaskNetwork network;
        Task visit;
        visit.name = "visit";
        visit.arguments = 2;
        visit.run = Visits::run;
        visit.context = &visits;
        const TaskId each = network.add(visit).value();
        RangeSteps steps = given;
        const TaskId range = network.add(make_range_task("range", steps, each)).value();
        test_support::RewrittenStream s(test_support::stream_settings(64, 32768));
        base::SerialWorkers workers;
        s.append({literal(5), literal(2000), call(range), literal(3000), literal(3000), call(range)});
        const StreamRewriter::Answer answer = s.rewriter.rewrite(network, workers, 10000);
        ASSERT_TRUE(answer.ok()) << answer.error().c_str();
        EXPECT_TRUE(answer.value().is_finished);
        EXPECT_EQ(visits.widest, std::min(1995u, steps.grain));
        for (std::uint32_t n = 0; n < 4000; ++n) ASSERT_EQ(visits.count[n], n >= 5 && n < 2000 ? 1u : 0u) << n;
        EXPECT_EQ(s.stream.words(), 0u);
    }
}

}  // namespace
}  // namespace tedavis::raytrace::test_range_task
