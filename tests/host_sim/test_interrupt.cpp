#include "host_sim/interrupt.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include "host_sim/user_error.hpp"

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

TEST(Interrupt, AGuardWithinAnotherOneIsTheSame) {
    const InterruptGuard outer;
    raise(SIGINT);
    {
        const InterruptGuard inner;
        EXPECT_TRUE(inner.requested()) << "a step sees what came before it";
        EXPECT_THROW(require_uninterrupted("out"), Interrupted);
    }
    EXPECT_TRUE(outer.requested());
}

TEST(Interrupt, AStepThatEndsLeavesTheHandlerToItsCommand) {
    const InterruptGuard outer;
    { const InterruptGuard inner; }
    require_uninterrupted("out");
    raise(SIGTERM);
    EXPECT_TRUE(outer.requested());
}

TEST(Interrupt, IsOverWithTheLastGuardAndSaysWhereNothingWasWritten) {
    {
        const InterruptGuard guard;
        raise(SIGINT);
        try {
            require_uninterrupted("out/run");
            ADD_FAILURE() << "it goes on";
        } catch (const Interrupted& interrupted) {
            EXPECT_STREQ(interrupted.what(), "interrupted; nothing was written to out/run");
        }
    }
    EXPECT_NO_THROW(require_uninterrupted("out/run"));
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
