#include "target/watchdog.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <string>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::target::test_watchdog {
namespace {

constexpr base::Duration kFrame = base::Duration::milliseconds(30);

/// The service manager's end.
class Manager {
public:
    explicit Manager(const std::string& path) : descriptor_(socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        path.copy(address.sun_path, sizeof address.sun_path - 1);
        if (path[0] == '@') address.sun_path[0] = '\0';
        const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
        EXPECT_EQ(bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    }
    ~Manager() { close(descriptor_); }
    [[nodiscard]] std::string message() const {
        char text[256];
        const ssize_t size = recv(descriptor_, text, sizeof text, 0);
        return size > 0 ? std::string(text, static_cast<std::size_t>(size)) : std::string();
    }

private:
    int descriptor_;
};

TEST(Watchdog, SaysWhatTheManagerUnderstands) {
    const test_support::TemporaryFolder folder;
    const Manager manager(folder.file("notify"));
    Watchdog watchdog(folder.file("notify"));
    ASSERT_TRUE(watchdog.connected());
    watchdog.ready();
    EXPECT_EQ(manager.message().substr(0, 8), "READY=1\n");
    watchdog.alive(kFrame);
    EXPECT_EQ(manager.message(), "WATCHDOG=1\n");
    watchdog.stopping();
    EXPECT_EQ(manager.message(), "STOPPING=1\n");
}

TEST(Watchdog, AsksForPatienceUntilFramesAreQuick) {
    const test_support::TemporaryFolder folder;
    const Manager manager(folder.file("notify"));
    Watchdog watchdog(folder.file("notify"), 5'000'000);
    watchdog.ready();
    EXPECT_EQ(manager.message(), "WATCHDOG_USEC=60000000\n");
    EXPECT_EQ(manager.message().substr(0, 8), "READY=1\n");
    for (int n = 0; n < 2 * Watchdog::kQuickFrames; ++n) {
        watchdog.alive(n == Watchdog::kQuickFrames - 1 ? base::Duration::seconds(4) : kFrame);
        EXPECT_EQ(manager.message(), "WATCHDOG=1\n");
        if (n + 1 < 2 * Watchdog::kQuickFrames) {
            EXPECT_EQ(manager.message(), "") << "a slow frame starts the count again";
        }
    }
    EXPECT_EQ(manager.message(), "WATCHDOG_USEC=5000000\n");
    watchdog.expect_slow_frames();
    watchdog.expect_slow_frames();
    EXPECT_EQ(manager.message(), "WATCHDOG_USEC=60000000\n");
    EXPECT_EQ(manager.message(), "") << "it is asked for once";
}

TEST(Watchdog, LeavesAManagerThatWaitsLongOrForeverAsItIs) {
    const test_support::TemporaryFolder folder;
    const Manager manager(folder.file("notify"));
    for (const std::uint64_t limit_us : {std::uint64_t{0}, std::uint64_t{120'000'000}}) {
        Watchdog watchdog(folder.file("notify"), limit_us);
        watchdog.ready();
        EXPECT_EQ(manager.message().substr(0, 8), "READY=1\n");
        for (int n = 0; n < Watchdog::kQuickFrames; ++n) {
            watchdog.alive(kFrame);
            EXPECT_EQ(manager.message(), "WATCHDOG=1\n");
        }
        EXPECT_EQ(manager.message(), "");
    }
}

TEST(Watchdog, TakesTheLimitFromTheEnvironment) {
    const test_support::TemporaryFolder folder;
    const Manager manager(folder.file("notify"));
    setenv("NOTIFY_SOCKET", folder.file("notify").c_str(), 1);
    setenv("WATCHDOG_USEC", "5000000", 1);
    Watchdog watchdog;
    unsetenv("NOTIFY_SOCKET");
    unsetenv("WATCHDOG_USEC");
    watchdog.expect_slow_frames();
    EXPECT_EQ(manager.message(), "WATCHDOG_USEC=60000000\n");
}

TEST(Watchdog, FindsTheSocketInTheEnvironmentAbstractNamesToo) {
    const std::string name = "@tedavis-test-" + std::to_string(getpid());
    const Manager manager(name);
    setenv("NOTIFY_SOCKET", name.c_str(), 1);
    Watchdog watchdog;
    unsetenv("NOTIFY_SOCKET");
    watchdog.alive(kFrame);
    EXPECT_EQ(manager.message(), "WATCHDOG=1\n");
}

TEST(Watchdog, WithoutAManagerItDoesNothing) {
    unsetenv("NOTIFY_SOCKET");
    Watchdog alone;
    EXPECT_FALSE(alone.connected());
    alone.alive(kFrame);
    EXPECT_FALSE(Watchdog("/nowhere/at/all").connected());
    EXPECT_FALSE(Watchdog("").connected());
    EXPECT_FALSE(Watchdog(std::string(200, 'x')).connected());
}

TEST(Watchdog, AManagerThatDoesNotReadHoldsNobody) {
    const test_support::TemporaryFolder folder;
    const Manager manager(folder.file("notify"));
    Watchdog watchdog(folder.file("notify"));
    for (int n = 0; n < 10000; ++n) watchdog.alive(kFrame);
    EXPECT_EQ(manager.message(), "WATCHDOG=1\n");
}

}  // namespace
}  // namespace tedavis::target::test_watchdog
