#include "bus/socketcan/socketcan_source.hpp"

#include <gtest/gtest.h>
#include <linux/can.h>
#include <linux/can/error.h>
#include <sys/socket.h>
#include <unistd.h>

#include <ctime>
#include <vector>

#include "bus/canaerospace/identification_service.hpp"

namespace tedavis::bus::test_socketcan_source {
namespace {

std::int64_t monotonic_ns = 0;
base::Time fake_monotonic() { return {monotonic_ns}; }
/// That of the kernel's stamps, and `wall_ahead_ns` later.
std::int64_t wall_ahead_ns = 0;
base::Time fake_wall() {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return {now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec + wall_ahead_ns};
}
constexpr LiveClocks kClocks{fake_monotonic, fake_wall};
constexpr std::int64_t kMs = 1'000'000;

/// A pair of connected sockets that keep message borders, in place of the kernel's CAN.
class PairPort final : public CanSocketPort {
public:
    ~PairPort() override {
        if (far_ >= 0) close(far_);
    }
    [[nodiscard]] OpenedSocket open(const SocketCanSettings&) override {
        ++attempts;
        if (refuse) return {-1, bus::SocketFaultText("CAN interface 'can0': there is no such interface")};
        int ends[2] = {-1, -1};
        EXPECT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0, ends), 0);
        const int yes = 1;
        if (stamps) EXPECT_EQ(setsockopt(ends[0], SOL_SOCKET, SO_TIMESTAMPNS, &yes, sizeof yes), 0);
        hang_up();
        far_ = ends[1];
        return {ends[0], {}};
    }
    template <class Record>
    void deliver(const Record& record) {
        ASSERT_EQ(::send(far_, &record, sizeof record, 0), static_cast<ssize_t>(sizeof record));
    }
    void hang_up() {
        if (far_ >= 0) close(far_);
        far_ = -1;
    }
    [[nodiscard]] int far_end() const { return far_; }
    bool refuse = false;
    bool stamps = false;  ///< the kernel's, of the instant of sending
    int attempts = 0;

private:
    int far_ = -1;
};

SocketCanSettings settings() {
    SocketCanSettings result;
    result.interface_name = "can0";
    return result;
}

can_frame classic(std::uint32_t id, std::uint8_t length = 8) {
    can_frame record{};
    record.can_id = id;
    record.can_dlc = length;
    return record;
}

struct SocketCanSourceTest : testing::Test {
    void SetUp() override {
        monotonic_ns = 100'000 * kMs;
        wall_ahead_ns = 0;
    }
    std::size_t read() { return source.read(fake_monotonic(), frames); }
    PairPort port;
    SocketCanSource source{port, settings(), kClocks};
    std::vector<CanFrame> frames = std::vector<CanFrame>(8);
};

TEST_F(SocketCanSourceTest, OpensAtTheFirstReadAndDeliversInOrder) {
    EXPECT_EQ(source.health(), SourceHealth::idle);
    EXPECT_EQ(read(), 0u);
    EXPECT_EQ(port.attempts, 1);
    for (std::uint32_t id = 1; id <= 10; ++id) port.deliver(classic(id));
    EXPECT_EQ(read(), 8u);
    EXPECT_EQ(frames[7].id, 8u);
    EXPECT_EQ(frames[0].time, fake_monotonic());
    EXPECT_EQ(read(), 2u);
    EXPECT_EQ(read(), 0u);
    EXPECT_EQ(source.health(), SourceHealth::running);
    EXPECT_EQ(source.statistics().frames, 10u);
}

/// More than a system call takes, broken records among them; what came before the end of the socket is not lost with it.
TEST_F(SocketCanSourceTest, AFullSocketIsReadInOrderToItsEnd) {
    (void)read();
    for (std::uint32_t id = 1; id <= 150; ++id) {
        port.deliver(classic(id));
        if (id % 10 == 0) port.deliver(std::uint32_t{7});
    }
    port.hang_up();
    std::uint32_t next = 1;
    for (int reading = 0; reading < 40; ++reading) {
        const std::size_t count = read();
        for (std::size_t n = 0; n < count; ++n) ASSERT_EQ(frames[n].id, next++);
    }
    EXPECT_EQ(next, 151u);
    EXPECT_EQ(source.statistics().frames, 150u);
    EXPECT_EQ(source.statistics().malformed, 15u);
    EXPECT_NE(source.last_fault().find("can0"), std::string_view::npos) << "and then the end is seen";
}

TEST_F(SocketCanSourceTest, ClassicAndFdRecordsAndBrokenOnes) {
    (void)read();
    canfd_frame fd{};
    fd.can_id = 0x12345 | CAN_EFF_FLAG;
    fd.len = 64;
    port.deliver(fd);
    port.deliver(std::uint32_t{7});
    port.deliver(classic(0x137, 9));
    port.deliver(classic(0x137));
    EXPECT_EQ(read(), 2u);
    EXPECT_EQ(frames[0].kind, FrameKind::fd);
    EXPECT_EQ(frames[0].length, 64);
    EXPECT_EQ(source.statistics().malformed, 2u);
}

TEST_F(SocketCanSourceTest, BusOffAndRestartAreReported) {
    (void)read();
    port.deliver(classic(CAN_ERR_FLAG | CAN_ERR_BUSOFF));
    EXPECT_EQ(read(), 1u);
    EXPECT_EQ(frames[0].kind, FrameKind::error);
    EXPECT_EQ(source.health(), SourceHealth::bus_off);
    EXPECT_EQ(read(), 0u);
    EXPECT_EQ(source.health(), SourceHealth::bus_off);
    port.deliver(classic(CAN_ERR_FLAG | CAN_ERR_RESTARTED));
    EXPECT_EQ(read(), 1u);
    EXPECT_EQ(source.health(), SourceHealth::running);
    EXPECT_EQ(source.statistics().error_frames, 2u);
}

TEST_F(SocketCanSourceTest, ALostSocketIsOpenedAgainAtABoundedRate) {
    (void)read();
    port.hang_up();
    EXPECT_EQ(read(), 0u);
    EXPECT_EQ(source.health(), SourceHealth::failed);
    EXPECT_NE(source.last_fault().find("can0"), std::string_view::npos);
    port.refuse = true;
    for (int i = 0; i < 50; ++i, monotonic_ns += 100 * kMs) (void)read();
    EXPECT_GE(port.attempts, 5);
    EXPECT_LE(port.attempts, 7) << "at most one a second";
    EXPECT_EQ(source.last_fault(), "CAN interface 'can0': there is no such interface");
    port.refuse = false;
    monotonic_ns += 1000 * kMs;
    (void)read();
    EXPECT_EQ(source.statistics().reopened, 1u);
    EXPECT_TRUE(source.last_fault().empty());
    port.deliver(classic(0x137));
    EXPECT_EQ(read(), 1u);
    EXPECT_EQ(source.health(), SourceHealth::running);
}

TEST_F(SocketCanSourceTest, FramesLaterThanAskedForWait) {
    (void)read();
    port.deliver(classic(0x137));
    const base::Time before{monotonic_ns - 1};
    EXPECT_EQ(source.read(before, frames), 0u);
    EXPECT_EQ(source.read(before, frames), 0u);
    EXPECT_EQ(read(), 1u);
    EXPECT_EQ(source.statistics().frames, 1u);
}

TEST_F(SocketCanSourceTest, AFrameIsAsOldAsItsStamp) {
    port.stamps = true;
    (void)read();
    port.deliver(classic(0x137));
    wall_ahead_ns = 700 * kMs;
    ASSERT_EQ(read(), 1u);
    const double age_s = (fake_monotonic() - frames[0].time).to_seconds();
    EXPECT_GE(age_s, 0.7);
    EXPECT_LT(age_s, 1.7) << "and the time of the test itself";
}

TEST_F(SocketCanSourceTest, WhatWaitedThroughAHaltIsReadAtOnceAndIsOld) {
    port.stamps = true;
    (void)read();
    for (int n = 0; n < 6; ++n) port.deliver(classic(0x137));
    wall_ahead_ns = 10'000 * kMs;
    ASSERT_EQ(source.read({monotonic_ns - 1}, frames), 6u) << "a full socket must not be emptied one frame a reading";
    for (std::size_t n = 0; n < 6; ++n) EXPECT_NEAR((fake_monotonic() - frames[n].time).to_seconds(), 2, 1e-9) << n;
    port.deliver(classic(0x137));
    wall_ahead_ns = -10'000 * kMs;
    ASSERT_EQ(read(), 1u);
    EXPECT_EQ(frames[0].time, fake_monotonic()) << "a stamp from the future: the clock was set back";
}

TEST_F(SocketCanSourceTest, SendsTheIdentificationAnswer) {
    EXPECT_FALSE(source.send(CanFrame())) << "not open yet";
    (void)read();
    port.deliver(classic(128, 4));
    ASSERT_EQ(read(), 1u);
    const IdentificationAnswer answer = answer_identification(frames[0], {true, 30, 2, 7});
    ASSERT_TRUE(answer.due);
    ASSERT_TRUE(source.send(answer.frame));
    can_frame sent{};
    ASSERT_EQ(recv(port.far_end(), &sent, sizeof sent, MSG_DONTWAIT), static_cast<ssize_t>(sizeof sent));
    EXPECT_EQ(sent.can_id, 129u);
    EXPECT_EQ(sent.can_dlc, 8);
    EXPECT_EQ(sent.data[5], 7);
    CanFrame impossible;
    impossible.kind = FrameKind::error;
    EXPECT_FALSE(source.send(impossible));
}

TEST_F(SocketCanSourceTest, AFullQueueRefusesInsteadOfBlocking) {
    (void)read();
    CanFrame frame;
    int sent = 0;
    while (sent < 100000 && source.send(frame)) ++sent;
    EXPECT_GT(sent, 0);
    EXPECT_LT(sent, 100000);
}

}  // namespace
}  // namespace tedavis::bus::test_socketcan_source
