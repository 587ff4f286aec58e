#include "render_core/raytrace/stream/thread_team.hpp"

#include "tests/support/raytrace/rewritten_stream.hpp"

namespace tedavis::raytrace::test_thread_team {
namespace {

constexpr std::uint32_t kWorks = 300, kPasses = 200;

struct Passes {
    std::vector<std::atomic<std::uint32_t>> done = std::vector<std::atomic<std::uint32_t>>(kWorks);
    std::vector<std::atomic<std::uint32_t>> busy = std::vector<std::atomic<std::uint32_t>>(64);
    std::vector<std::uint64_t> values = std::vector<std::uint64_t>(kWorks);
    std::uint32_t leads = 0, faults = 0;
    std::atomic<std::uint32_t> lane_faults{0};

    static void work(void* self, std::uint32_t index, std::uint32_t lane) {
        Passes& passes = *static_cast<Passes*>(self);
        if (passes.busy[lane]++ != 0) ++passes.lane_faults;
        ++passes.done[index];
        passes.values[index] = passes.values[index] * 31 + index;  // by another worker in each pass
        --passes.busy[lane];
    }
    static void lead(void* self, ThreadTeam& team) {
        Passes& passes = *static_cast<Passes*>(self);
        ++passes.leads;
        for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
            team.share(kWorks - pass, &Passes::work, self);
            for (std::uint32_t n = 0; n < kWorks - pass; ++n) passes.faults += passes.done[n] == pass + 1 ? 0 : 1;
        }
    }
};

TEST(ThreadTeam, EveryPassIsDoneOnceAndWhole) {
    base::SerialWorkers serial;
    Passes expected;
    ThreadTeam::run(serial, 1, &Passes::lead, &expected);
    for (const std::uint32_t count : test_support::kWorkerCounts) {
        const std::unique_ptr<base::Workers> workers = test_support::make_workers(count);
        for (int run = 0; run < 5; ++run) {
            Passes passes;
            ThreadTeam::run(*workers, count, &Passes::lead, &passes);
            EXPECT_EQ(passes.leads, 1u);
            EXPECT_EQ(passes.faults, 0u);
            EXPECT_EQ(passes.lane_faults, 0u);
            EXPECT_EQ(passes.values, expected.values);
        }
    }
}

TEST(ThreadTeam, TheLeaderNeedsNobody) {
    base::SerialWorkers serial;  // one after the other: the others come when all is over
    Passes passes;
    ThreadTeam::run(serial, 7, &Passes::lead, &passes);
    EXPECT_EQ(passes.leads, 1u);
    EXPECT_EQ(passes.faults, 0u);
    EXPECT_EQ(passes.done[0], kPasses);
}

}  // namespace
}  // namespace tedavis::raytrace::test_thread_team
