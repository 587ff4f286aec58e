// libseat's own backends stand for a manager: `builtin`, which without virtual terminals (SEATD_VTBOUND=0) touches none, and
// `noop`, which opens every file.
#include "platform/egl_kms/seat_port.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "platform/egl_kms/seat_offer.hpp"

namespace tedavis::platform::test_seat_port {
namespace {

struct Events final : SeatListener {
    void on_enable() override { seen += "e"; }
    void on_disable() override { seen += "d"; }
    std::string seen;
};

struct SeatPortOf : testing::Test {
    void SetUp() override {
        ASSERT_TRUE(can_use_seats()) << "libseat was missing at the build; toolchains/install_packages core installs it";
    }
    void TearDown() override {
        if (port != nullptr) port->close();
        while (::waitpid(-1, nullptr, 0) > 0) {
        }  // libseat leaves its process to us
        unsetenv("LIBSEAT_BACKEND");
        unsetenv("SEATD_VTBOUND");
    }
    const std::unique_ptr<SeatPort> port = make_libseat_port();
    Events events;
};

// The backend `builtin` goes on in a child after fork(), which the thread sanitizer cannot follow where other threads run: the
// child then stands still now and then.
#if !defined(__SANITIZE_THREAD__)

TEST_F(SeatPortOf, TheLibraryOpensASeatAndEnablesIt) {
    setenv("LIBSEAT_BACKEND", "builtin", 1);
    setenv("SEATD_VTBOUND", "0", 1);
    ASSERT_TRUE(port->open(events));
    EXPECT_EQ(port->manager().view(), "builtin");
    for (int n = 0; n < 100 && events.seen.empty(); ++n) ASSERT_TRUE(port->dispatch(100));
    EXPECT_EQ(events.seen, "e");
    int descriptor = -1;
    EXPECT_LT(port->open_device("/dev/null", descriptor), 0) << "a manager opens screens and keyboards alone";
    EXPECT_EQ(errno, ENOENT);
    EXPECT_TRUE(port->dispatch(0));
}

/// The process that libseat started, the only child of this one; 0 where there is none.
pid_t child_process() {
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::string line;
        std::getline(std::ifstream(entry.path() / "stat"), line);
        const std::size_t name_end = line.rfind(')');  // "123 (name) S 1 ..."
        if (name_end == std::string::npos) continue;
        if (std::strtol(line.c_str() + name_end + 4, nullptr, 10) == ::getpid())
            return static_cast<pid_t>(std::strtol(line.c_str(), nullptr, 10));
    }
    return 0;
}

TEST_F(SeatPortOf, AManagerThatEndedIsNoticedWithoutWaiting) {
    setenv("LIBSEAT_BACKEND", "builtin", 1);
    setenv("SEATD_VTBOUND", "0", 1);
    ASSERT_TRUE(port->open(events));
    const pid_t manager = child_process();
    ASSERT_GT(manager, 0);
    EXPECT_TRUE(port->dispatch(0));
    ASSERT_EQ(::kill(manager, SIGKILL), 0);
    siginfo_t ended{};
    ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(manager), &ended, WEXITED | WNOWAIT), 0) << "closed its connection";
    EXPECT_FALSE(port->dispatch(0));
}

#endif

TEST_F(SeatPortOf, TheLibraryOpensADevice) {
    setenv("LIBSEAT_BACKEND", "noop", 1);
    ASSERT_TRUE(port->open(events));
    EXPECT_EQ(port->manager().view(), "noop");
    EXPECT_TRUE(port->dispatch(0));
    int descriptor = -1;
    const int device = port->open_device("/dev/null", descriptor);
    EXPECT_GE(device, 0);
    EXPECT_EQ(::write(descriptor, "x", 1), 1);
    EXPECT_LT(port->open_device("/dev/tedavis-absent", descriptor), 0);
    EXPECT_TRUE(port->disable());
    port->close_device(device);
    EXPECT_EQ(::close(descriptor), 0) << "the library leaves the descriptor open";
}

TEST_F(SeatPortOf, ABackendThatDoesNotExistGivesNoSeat) {
    setenv("LIBSEAT_BACKEND", "tedavis-absent", 1);
    EXPECT_FALSE(port->open(events));
    EXPECT_TRUE(port->manager().empty());
    EXPECT_EQ(events.seen, "");
}

TEST(SeatPort, IsThereWithTheLibraryAlone) { EXPECT_EQ(make_libseat_port() != nullptr, can_use_seats()); }

}  // namespace
}  // namespace tedavis::platform::test_seat_port
