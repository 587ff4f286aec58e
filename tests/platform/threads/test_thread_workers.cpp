// What the threads must do as Workers stands in tests/contracts; here is what only they do.
#include "platform/threads/thread_workers.hpp"

#include <gtest/gtest.h>

#include <atomic>

namespace tedavis::platform::test_thread_workers {
namespace {

std::atomic<int> started{0};

TEST(ThreadWorkers, CallTheHookInEveryNewThread) {
    started = 0;
    {
        const auto workers = make_thread_workers({4, [] { ++started; }});
        ASSERT_TRUE(workers.ok());
    }
    EXPECT_LE(started, 3) << "not on the caller";
    started = 0;
    {
        const auto workers = make_thread_workers({4, [] { ++started; }});
        ASSERT_TRUE(workers.ok());
        // Every thread takes part in every round, so after one all have started.
        workers.value()->parallel_for(
            64, [](void*, std::uint32_t) {}, nullptr);
        EXPECT_EQ(started, 3);
    }
}

TEST(ThreadWorkers, RefuseImpossibleNumbers) {
    EXPECT_FALSE(make_thread_workers({0, nullptr}).ok());
    EXPECT_FALSE(make_thread_workers({kMaxWorkers + 1, nullptr}).ok());
}

TEST(UsableProcessors, AreAtLeastOne) {
    EXPECT_GE(usable_processors(), 1u);
    EXPECT_LE(usable_processors(), kMaxWorkers);
}

}  // namespace
}  // namespace tedavis::platform::test_thread_workers
