#include "host_sim/flight_test/live_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>

#include "bus/socketcan/kernel_frame.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_live_board {
namespace {

/// A pair of sockets in place of the CAN interface.
class PairPort final : public bus::CanSocketPort {
public:
    ~PairPort() override {
        if (bus_ >= 0) ::close(bus_);
    }
    [[nodiscard]] bus::OpenedSocket open(const bus::SocketCanSettings& asked) override {
        settings = asked;
        std::array<int, 2> pair{-1, -1};
        if (!opens || ::socketpair(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0, pair.data()) != 0) return {-1, "no pair"};
        bus_ = pair[1];
        return {pair[0], {}};
    }
    [[nodiscard]] bus::SocketFaultText explain(const bus::SocketCanSettings&) override { return fault; }
    [[nodiscard]] int bus() const { return bus_; }

    bool opens = true;
    bus::SocketCanSettings settings;
    bus::SocketFaultText fault;

private:
    int bus_ = -1;
};

/// The socket of a display.
class Display {
public:
    explicit Display(const std::string& path) : listener_(::socket(AF_UNIX, SOCK_SEQPACKET, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, path.data(), path.size());
        const void* const plain = &address;
        EXPECT_EQ(::bind(listener_, static_cast<const sockaddr*>(plain), sizeof address), 0);
        EXPECT_EQ(::listen(listener_, 1), 0);
    }
    ~Display() {
        leave();
        ::close(listener_);
    }
    void say(const std::string& packet) {
        if (reader_ < 0) reader_ = ::accept(listener_, nullptr, nullptr);
        EXPECT_EQ(::send(reader_, packet.data(), packet.size(), 0), static_cast<ssize_t>(packet.size()));
    }
    void leave() {
        if (reader_ >= 0) ::close(reader_);
        reader_ = -1;
    }

private:
    int listener_, reader_ = -1;
};

class LiveBoardTest : public ::testing::Test {
protected:
    LiveBoardTest() : display_(place_.file("records")) {
        for (int n = 0; n < 7; ++n) {
            const std::string line = "chip/sim_gpio" + std::to_string(n);
            std::filesystem::create_directories(place_.file(line));
            place_.write(line + "/pull", "");
        }
        const std::string path = resolve_config("one_hot", "switches");
        panel_ = bus::load_switch_config(read_file(path), path).value();
    }
    LiveBoardOptions options() const { return {place_.file("records"), "can0", place_.file("chip")}; }
    void expect_fault(const LiveBoardOptions& options, const std::string& words) {
        test_support::expect_user_error([&] { const LiveBoard board(options, panel_, port_); }, words);
    }
    test_support::TemporaryFolder place_;
    Display display_;
    PairPort port_;
    bus::SwitchConfig panel_;
};

TEST_F(LiveBoardTest, ReadsRecordsInTurnAndWaitsNoLongerThanAsked) {
    LiveBoard board(options(), panel_, port_);
    display_.say("one");
    display_.say("two");
    EXPECT_EQ(board.next_record(board.now() + base::Duration::seconds(60)), "one");
    EXPECT_EQ(board.next_record(board.now()), "two");
    EXPECT_EQ(board.next_record(board.now() + base::Duration::milliseconds(3)), std::nullopt);
    display_.leave();
    EXPECT_THROW(static_cast<void>(board.next_record(board.now() + base::Duration::seconds(60))), BoardLost);
}

TEST_F(LiveBoardTest, SendsFramesAndDoesNotFillUpWithThoseOfOthers) {
    LiveBoard board(options(), panel_, port_);
    bus::CanFrame frame;
    frame.id = 0x137;
    frame.length = 8;
    frame.data[0] = 9;
    board.send(frame);
    std::array<unsigned char, bus::kKernelFdFrameBytes> bytes{};
    const ssize_t size = ::recv(port_.bus(), bytes.data(), bytes.size(), 0);
    bus::CanFrame received;
    ASSERT_GT(size, 0);
    ASSERT_TRUE(bus::frame_from_kernel({bytes.data(), static_cast<std::size_t>(size)}, received));
    EXPECT_EQ(received.id, 0x137u);
    for (int n = 0; n < 2000; ++n) {
        while (::send(port_.bus(), bytes.data(), static_cast<std::size_t>(size), MSG_DONTWAIT) > 0) {
        }
        static_cast<void>(board.next_record(board.now()));
    }
    EXPECT_GT(::send(port_.bus(), bytes.data(), static_cast<std::size_t>(size), MSG_DONTWAIT), 0) << "there is room again";
}

/// A display without CAN FD would see none of it, however long the queue is.
TEST_F(LiveBoardTest, AFrameOfCanFdNeedsABusThatTakesIt) {
    bus::CanFrame frame;
    frame.kind = bus::FrameKind::fd;
    frame.length = 64;
    LiveBoard plain(options(), panel_, port_);
    test_support::expect_user_error([&] { plain.send(frame); }, "say fd = true under [can]");
    LiveBoardOptions with_fd = options();
    with_fd.can_fd = true;
    LiveBoard board(with_fd, panel_, port_);
    EXPECT_TRUE(port_.settings.can_fd);
    board.send(frame);
    std::array<unsigned char, bus::kKernelFdFrameBytes> bytes{};
    EXPECT_EQ(::recv(port_.bus(), bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
}

/// Nobody empties the queue.
TEST_F(LiveBoardTest, ABusThatTakesNothingIsLost) {
    LiveBoard board(options(), panel_, port_);
    const bus::CanFrame frame;
    try {
        for (int n = 0; n < 100'000; ++n) board.send(frame);
        ADD_FAILURE() << "it took all";
    } catch (const BoardLost& lost) {
        EXPECT_THAT(lost.what(), ::testing::HasSubstr("takes no frame: its queue is full; see that another node"));
    }
}

TEST_F(LiveBoardTest, PullsLinesAsTheirLevelsAre) {
    panel_.lines[2].active_low = true;
    LiveBoard board(options(), panel_, port_);
    EXPECT_TRUE(board.has_panel());
    board.set_line(1, true);
    board.set_line(2, true);
    EXPECT_EQ(place_.read("chip/sim_gpio1/pull"), "pull-up");
    EXPECT_EQ(place_.read("chip/sim_gpio2/pull"), "pull-down");
    panel_.lines[1].offset = 5;
    LiveBoard other(options(), panel_, port_);
    other.set_line(1, true);
    EXPECT_EQ(place_.read("chip/sim_gpio5/pull"), "pull-up");
}

TEST_F(LiveBoardTest, WhatIsMissingIsNamed) {
    LiveBoardOptions no_display = options();
    no_display.socket = place_.file("nothing");
    expect_fault(no_display, "no display hands out records there: No such file or directory; start tedavis-display");
    no_display.socket = std::string(200, 'x');
    expect_fault(no_display, "longer than the name of a socket");
    LiveBoardOptions no_lines = options();
    no_lines.panel_lines = place_.file("elsewhere");
    expect_fault(no_lines, "the line 'GROUND' of the panel cannot be pulled");
    LiveBoardOptions no_name = options();
    no_name.interface = "";
    expect_fault(no_name, "--interface");
    port_.opens = false;
    expect_fault(options(), "no pair");
    port_.fault = "CAN interface 'can0': is down; switch it on";
    expect_fault(options(), "CAN interface 'can0': is down");
}

}  // namespace
}  // namespace tedavis::host_sim::test_live_board
