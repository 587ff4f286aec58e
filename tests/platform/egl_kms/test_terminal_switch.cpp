#include "platform/egl_kms/terminal_switch.hpp"

#include <gtest/gtest.h>

namespace tedavis::platform::test_terminal_switch {
namespace {

volatile sig_atomic_t own_handler_calls = 0;

TEST(TerminalSwitch, WithoutAVirtualTerminalSignalsStayTheProgramsOwn) {
    struct sigaction own {
    }, before{}, after{};
    own.sa_handler = [](int) { own_handler_calls = own_handler_calls + 1; };
    sigaction(SIGUSR1, &own, &before);
    {
        TerminalSwitch terminal;
        for (const char* path : {"/dev/null", "/dev/tedavis-absent"}) EXPECT_FALSE(terminal.start(path)) << path;
        EXPECT_FALSE(terminal.is_active());
        raise(SIGUSR1);
        EXPECT_EQ(own_handler_calls, 1);
        EXPECT_EQ(terminal.take_request(), TerminalRequest::none);
        EXPECT_FALSE(terminal.answer(TerminalRequest::release));
        terminal.stop();
    }
    sigaction(SIGUSR1, &before, &after);
    EXPECT_EQ(after.sa_handler, own.sa_handler);
}

TEST(TerminalSwitch, ItsSignalsAreNoOthers) {
    for (const int taken : {SIGINT, SIGTERM, SIGUSR1}) {
        EXPECT_NE(TerminalSwitch::release_signal(), taken);
        EXPECT_NE(TerminalSwitch::acquire_signal(), taken);
    }
    EXPECT_NE(TerminalSwitch::release_signal(), TerminalSwitch::acquire_signal());
}

}  // namespace
}  // namespace tedavis::platform::test_terminal_switch
