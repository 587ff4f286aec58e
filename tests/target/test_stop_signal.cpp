#include "target/stop_signal.hpp"

#include <gtest/gtest.h>

namespace tedavis::target::test_stop_signal {
namespace {

TEST(StopSignal, TakesTheFirstSignalOfEitherKind) {
    for (const int number : {SIGINT, SIGTERM}) {
        const StopSignal stop;
        EXPECT_FALSE(stop.requested());
        raise(number);
        EXPECT_TRUE(stop.requested());
    }
    const StopSignal fresh;
    EXPECT_FALSE(fresh.requested()) << "an earlier request is over";
}

TEST(StopSignal, GivesTheHandlersBack) {
    struct sigaction mine {
    }, found{};
    mine.sa_handler = SIG_IGN;
    sigaction(SIGTERM, &mine, nullptr);
    { const StopSignal stop; }
    sigaction(SIGTERM, nullptr, &found);
    EXPECT_EQ(found.sa_handler, SIG_IGN);
    mine.sa_handler = SIG_DFL;
    sigaction(SIGTERM, &mine, nullptr);
}

TEST(StopSignalDeathTest, TheSecondSignalEndsTheProgram) {
    EXPECT_EXIT(
        {
            const StopSignal stop;
            raise(SIGTERM);
            raise(SIGTERM);
        },
        testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace tedavis::target::test_stop_signal
