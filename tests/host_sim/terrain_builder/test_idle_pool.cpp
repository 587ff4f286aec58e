#include "host_sim/terrain_builder/idle_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace tedavis::host_sim::test_idle_pool {
namespace {

/// Tells when two have it at once.
struct Thing {
    std::atomic<int> users{0};
};

TEST(IdlePool, MakesOneOnlyWhenNoneIsIdle) {
    IdlePool<Thing> pool;
    int made = 0;
    const auto make = [&made] {
        ++made;
        return std::make_unique<Thing>();
    };
    std::unique_ptr<Thing> first = pool.take(make), second = pool.take(make);
    EXPECT_EQ(made, 2) << "both are in use";
    const Thing* const known = first.get();
    pool.give_back(std::move(first));
    EXPECT_EQ(pool.take(make).get(), known);
    EXPECT_EQ(made, 2);
    EXPECT_NE(pool.take(make), nullptr) << "the one before was not given back";
    EXPECT_EQ(made, 3);
}

TEST(IdlePool, StaysSoundWhenOneCannotBeMade) {
    IdlePool<Thing> pool;
    const auto refuse = []() -> std::unique_ptr<Thing> { throw std::runtime_error("no such file"); };
    EXPECT_THROW(static_cast<void>(pool.take(refuse)), std::runtime_error);
    pool.give_back(std::make_unique<Thing>());
    EXPECT_NE(pool.take(refuse), nullptr) << "an idle one needs no making";
}

TEST(IdlePool, GivesEachThingToOneThreadAtATime) {
    constexpr int kThreads = 4, kRounds = 2000;
    IdlePool<Thing> pool;
    std::atomic<int> made{0}, shared{0};
    const auto work = [&] {
        for (int n = 0; n < kRounds; ++n) {
            std::unique_ptr<Thing> thing = pool.take([&made] {
                ++made;
                return std::make_unique<Thing>();
            });
            shared += ++thing->users == 1 ? 0 : 1;
            --thing->users;
            pool.give_back(std::move(thing));
        }
    };
    std::vector<std::thread> threads;
    for (int n = 0; n < kThreads; ++n) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(shared, 0);
    EXPECT_LE(made, kThreads) << "as many as were in use at once";
}

}  // namespace
}  // namespace tedavis::host_sim::test_idle_pool
