#include "target/board_clocks.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/time.h>

#include <chrono>

namespace tedavis::target::test_board_clocks {
namespace {

TEST(BoardClocks, AreTheMachinesOwn) {
    const BoardClocks clocks = machine_clocks();
    const auto before = std::chrono::system_clock::now().time_since_epoch();
    const base::Time wall = clocks.live.wall();
    const auto after = std::chrono::system_clock::now().time_since_epoch();
    EXPECT_GE(wall.ns, std::chrono::nanoseconds(before).count());
    EXPECT_LE(wall.ns, std::chrono::nanoseconds(after).count());
    const std::int64_t steady = std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
    EXPECT_GE(clocks.live.monotonic().ns, steady);
}

TEST(BoardClocks, SleepNeverEndsEarlyAndThePastIsNoSleep) {
    const BoardClocks clocks = machine_clocks();
    const base::Time end = clocks.live.monotonic() + base::Duration::milliseconds(20);
    clocks.sleep_until(end);
    EXPECT_GE(clocks.live.monotonic(), end);
    clocks.sleep_until(base::Time{});
    clocks.sleep_until(base::Time{-5});
    clocks.sleep_until(end);
}

TEST(BoardClocks, ASignalEndsTheSleep) {
    const BoardClocks clocks = machine_clocks();
    struct sigaction wake {
    }, previous{};
    wake.sa_handler = [](int) {};
    sigaction(SIGALRM, &wake, &previous);
    const itimerval soon{{0, 0}, {0, 10'000}};
    setitimer(ITIMER_REAL, &soon, nullptr);
    const base::Time end = clocks.live.monotonic() + base::Duration::seconds(250);
    clocks.sleep_until(end);
    EXPECT_LT(clocks.live.monotonic(), end);
    sigaction(SIGALRM, &previous, nullptr);
}

}  // namespace
}  // namespace tedavis::target::test_board_clocks
