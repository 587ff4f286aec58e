#include "host_sim/terrain_builder/staged_run.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_staged_run {
namespace {

/// Three stages that note which of their tasks were finished, in order.
struct Work {
    std::vector<std::string> done;
    std::vector<BuildStage> stages;

    Work() {
        for (const auto& [name, count] : {std::pair{"a", 3u}, {"b", 0u}, {"c", 5u}}) {
            stages.push_back({name, 10.0, [count = count] { return count; },
                              [this, name = std::string(name)](std::uint32_t n) {
                                  return std::function<void()>([this, name, n] { done.push_back(name + std::to_string(n)); });
                              }});
        }
    }
};

struct KeptRun {
    test_support::TemporaryFolder place;
    base::SerialWorkers workers;
    int syncs = 0;

    /// Stops after `steps` steps of progress.
    bool go(Work& work, int steps, std::chrono::milliseconds interval, BuildProgress progress = {}) {
        BuildJournal journal(place.file("w"), 5);
        BuildRecord record = journal.last();
        const auto told = [&](std::string_view stage, std::uint64_t done, std::uint64_t total) {
            if (progress) progress(stage, done, total);
            if (--steps == 0) throw std::runtime_error("stop");
        };
        try {
            StagedRun(
                journal, record, workers, told, [this] { ++syncs; }, interval)
                .run(work.stages);
        } catch (const std::runtime_error&) {
            return false;
        }
        return true;
    }
};

TEST(StagedRun, DoesEveryTaskInOrderAndTellsHowFarItIs) {
    Work work;
    KeptRun run;
    std::vector<std::uint64_t> told;
    EXPECT_TRUE(run.go(work, -1, std::chrono::hours(1), [&](std::string_view, std::uint64_t done, std::uint64_t total) {
        told.push_back(done);
        EXPECT_EQ(total, 1000000u);
    }));
    EXPECT_EQ(work.done, (std::vector<std::string>{"a0", "a1", "a2", "c0", "c1", "c2", "c3", "c4"}));
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1000000u);
    EXPECT_EQ(run.syncs, 1) << "one record at the end";
}

TEST(StagedRun, GoesOnWhereItStopped) {
    for (int stop = 1; stop <= 8; ++stop) {
        Work work;
        KeptRun run;
        int attempts = 1;
        while (!run.go(work, stop, std::chrono::hours(1))) ++attempts;
        EXPECT_EQ(work.done, (std::vector<std::string>{"a0", "a1", "a2", "c0", "c1", "c2", "c3", "c4"})) << stop;
        EXPECT_EQ(attempts, 8 / stop + 1);
    }
}

TEST(StagedRun, RecordsAsOftenAsItIsAsked) {
    Work work;
    KeptRun run;
    EXPECT_TRUE(run.go(work, -1, std::chrono::milliseconds(0)));
    EXPECT_EQ(run.syncs, 9);
}

TEST(StagedRun, AFailingTaskEndsItWithARecord) {
    Work work;
    work.stages[2].task = [](std::uint32_t n) {
        if (n == 2) throw std::runtime_error("disk full");
        return std::function<void()>([] {});
    };
    KeptRun run;
    EXPECT_FALSE(run.go(work, -1, std::chrono::hours(1)));
    const BuildJournal journal(run.place.file("w"), 5);
    EXPECT_EQ(journal.last().stage, 2u);
    EXPECT_EQ(journal.last().next, 2u);
}

TEST(StagedRun, AResultThatIsHalfKeptIsNotKept) {
    const test_support::TemporaryFolder place;
    BuildJournal journal(place.file("w"), 5);
    BuildRecord record;
    base::SerialWorkers workers;
    const std::vector<BuildStage> stages = {{"a", 1, [] { return 3u; },
                                             [&record](std::uint32_t n) {
                                                 return std::function<void()>([&record, n] {
                                                     record.end += 100;
                                                     if (n == 1) throw std::runtime_error("disk full");
                                                 });
                                             }}};
    StagedRun run(
        journal, record, workers, {}, [] {}, std::chrono::hours(1));
    EXPECT_THROW(run.run(stages), std::runtime_error);
    EXPECT_EQ(record.end, 100u);
    EXPECT_EQ(journal.last().next, 1u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_staged_run
