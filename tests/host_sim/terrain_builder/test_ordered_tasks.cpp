#include "host_sim/terrain_builder/ordered_tasks.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "platform/threads/thread_workers.hpp"

namespace tedavis::host_sim::test_ordered_tasks {
namespace {

std::unique_ptr<base::Workers> workers(std::uint32_t count) {
    return std::move(platform::make_thread_workers({count, nullptr}).value());
}

TEST(OrderedTasks, ResultsComeInOrderWhateverFinishesFirst) {
    const auto four = workers(4);
    std::vector<std::uint32_t> order;
    run_in_order(
        *four, 3, 60,
        [](std::uint32_t n) {
            if (n % 4 == 3) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            return n * n;
        },
        [&](std::uint32_t n, std::uint32_t square) {
            EXPECT_EQ(square, n * n);
            order.push_back(n);
        });
    std::vector<std::uint32_t> expected(57);
    std::iota(expected.begin(), expected.end(), 3u);
    EXPECT_EQ(order, expected);
}

TEST(OrderedTasks, FewResultsWaitForTheirTurn) {
    const auto four = workers(4);
    std::atomic<int> alive{0}, most{0};
    run_in_order(
        *four, 0, 200,
        [&](std::uint32_t n) {
            if (n % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
            const int now = ++alive;
            int before = most;
            while (now > before && !most.compare_exchange_weak(before, now)) {
            }
            return n;
        },
        [&](std::uint32_t, std::uint32_t) { --alive; });
    EXPECT_LE(most, 9) << "one a worker, and as many that wait";
}

TEST(OrderedTasks, TheFirstFailureEndsTheRun) {
    for (const std::uint32_t threads : {1u, 4u}) {
        const auto some = workers(threads);
        std::uint32_t committed = 0;
        try {
            run_in_order(
                *some, 0, 1000,
                [](std::uint32_t n) {
                    if (n == 7 || n == 9) throw std::runtime_error(std::to_string(n));
                    return n;
                },
                [&](std::uint32_t n, std::uint32_t) { committed = n + 1; });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_TRUE(std::string(error.what()) == "7" || std::string(error.what()) == "9");
        }
        EXPECT_LE(committed, 7u);
    }
}

TEST(OrderedTasks, AFailureOfCommitEndsTheRunToo) {
    const auto four = workers(4);
    std::uint32_t committed = 0;
    EXPECT_THROW(run_in_order(
                     *four, 0, 1000, [](std::uint32_t n) { return n; },
                     [&](std::uint32_t n, std::uint32_t) {
                         if (n == 20) throw std::runtime_error("stop");
                         ++committed;
                     }),
                 std::runtime_error);
    EXPECT_EQ(committed, 20u);
}

TEST(OrderedTasks, NothingToDoIsDone) {
    run_in_order(
        *workers(2), 5, 5, [](std::uint32_t n) { return n; }, [](std::uint32_t, std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace tedavis::host_sim::test_ordered_tasks
