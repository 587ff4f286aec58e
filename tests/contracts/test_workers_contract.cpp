// What every Workers must do, run serially and with several numbers of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::platform::test_workers_contract {
namespace {

class WorkersContract : public testing::TestWithParam<std::uint32_t> {  // 0: SerialWorkers
protected:
    WorkersContract() {
        if (GetParam() == 0) {
            workers_ = std::make_unique<base::SerialWorkers>();
            return;
        }
        auto made = make_thread_workers({GetParam(), nullptr});
        EXPECT_TRUE(made.ok());
        workers_ = std::move(made.value());
    }
    std::unique_ptr<base::Workers> workers_;
};

struct Counts {
    std::vector<std::atomic<int>> calls;
    explicit Counts(std::size_t count) : calls(count) {}
    static void task(void* context, std::uint32_t index) { ++static_cast<Counts*>(context)->calls[index]; }
};

TEST_P(WorkersContract, SayHowManyTheyAre) { EXPECT_EQ(workers_->concurrency(), GetParam() == 0 ? 1u : GetParam()); }

TEST_P(WorkersContract, EveryIndexIsDoneOnceBeforeTheReturn) {
    for (std::uint32_t count : {0u, 1u, 2u, 3u, 64u, 10'000u}) {
        Counts counts(count);
        workers_->parallel_for(count, &Counts::task, &counts);
        for (const std::atomic<int>& calls : counts.calls) ASSERT_EQ(calls.load(), 1);
    }
}

TEST_P(WorkersContract, ManyRoundsFollowOneAnother) {
    Counts counts(5);
    for (int round = 0; round < 2000; ++round) workers_->parallel_for(5, &Counts::task, &counts);
    for (const std::atomic<int>& calls : counts.calls) EXPECT_EQ(calls.load(), 2000);
}

/// A floating-point sum whose order is fixed by the index, as the core uses the workers.
struct Sums {
    std::vector<double> parts = std::vector<double>(97);
    static void task(void* context, std::uint32_t index) {
        double sum = 0;
        for (std::uint32_t k = 1; k < 500; ++k) sum += 1.0 / (index + k * 0.37);
        static_cast<Sums*>(context)->parts[index] = sum;
    }
};

TEST_P(WorkersContract, ResultsAreThoseOfTheSerialRunBitForBit) {
    Sums serial, parallel;
    base::SerialWorkers().parallel_for(97, &Sums::task, &serial);
    workers_->parallel_for(97, &Sums::task, &parallel);
    EXPECT_EQ(parallel.parts, serial.parts);
    const double in_order = std::accumulate(serial.parts.begin(), serial.parts.end(), 0.0);
    int different = 0;
    for (int n = 0; n < 100; ++n) {
        workers_->parallel_for(97, &Sums::task, &parallel);
        different += std::accumulate(parallel.parts.begin(), parallel.parts.end(), 0.0) != in_order;
    }
    EXPECT_EQ(different, 0);
    test_support::record_worst("A47", different);
}

/// The naive form adds each part where its task ends, so the order is that of arrival: of a hundred orders most give other bits.
TEST(WorkersOrder, ASumInTheOrderOfArrivalHasOtherBits) {
    Sums sums;
    base::SerialWorkers().parallel_for(97, &Sums::task, &sums);
    const double in_order = std::accumulate(sums.parts.begin(), sums.parts.end(), 0.0);
    std::mt19937 dice(7);
    int different = 0;
    for (int n = 0; n < 100; ++n) {
        std::shuffle(sums.parts.begin(), sums.parts.end(), dice);
        different += std::accumulate(sums.parts.begin(), sums.parts.end(), 0.0) != in_order;
    }
    EXPECT_GT(different, 50);
    test_support::record_control("A47", different);
}

INSTANTIATE_TEST_SUITE_P(Numbers, WorkersContract, testing::Values(0u, 1u, 2u, 3u, 8u));

}  // namespace
}  // namespace tedavis::platform::test_workers_contract
