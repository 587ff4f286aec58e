#include "host_sim/interrupt.hpp"

#include <gtest/gtest.h>
#include <signal.h>

namespace tedavis::host_sim::test_interrupt {
namespace {

TEST(Interrupt, TheFirstSignalOnlySetsTheFlag) {
    {
        const InterruptGuard guard;
        EXPECT_FALSE(guard.requested());
        raise(SIGINT);
        EXPECT_TRUE(guard.requested());
    }
    const InterruptGuard next;
    EXPECT_FALSE(next.requested());
    raise(SIGTERM);
    EXPECT_TRUE(next.requested());
}

TEST(Interrupt, TheSecondSignalEndsTheProgram) {
    EXPECT_EXIT(
        {
            const InterruptGuard guard;
            raise(SIGINT);
            raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT), "");
}

TEST(Interrupt, TheHandlerBeforeComesBack) {
    static int seen = 0;
    struct sigaction own {
    }, before{};
    own.sa_handler = [](int) { ++seen; };
    sigaction(SIGINT, &own, &before);
    { const InterruptGuard guard; }
    raise(SIGINT);
    sigaction(SIGINT, &before, nullptr);
    EXPECT_EQ(seen, 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_interrupt
