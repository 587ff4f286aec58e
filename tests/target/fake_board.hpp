/// A board without hardware: a socket pair in place of the CAN interface, a clock that tests turn, a log that they read.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "bus/socketcan/kernel_frame.hpp"
#include "target/board_clocks.hpp"
#include "target/board_config.hpp"
#include "target/event_log.hpp"
#include "target/self_test.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::target {

/// The clock of all fake boards: one test at a time runs in a process.
struct FakeClock {
    static inline std::int64_t now_ns = 0;
    static inline void (*on_sleep)() = nullptr;

    static base::Time monotonic() { return {now_ns}; }
    static base::Time wall() { return {1'700'000'000'000'000'000 + now_ns}; }
    static void sleep_until(base::Time time) {
        now_ns = std::max(now_ns, time.ns);
        if (on_sleep != nullptr) on_sleep();
    }
    static BoardClocks clocks() { return {{&monotonic, &wall}, &sleep_until}; }
    static void reset() {
        now_ns = 100'000'000'000;
        on_sleep = nullptr;
    }
};

class PairPort final : public bus::CanSocketPort {
public:
    ~PairPort() override { hang_up(); }
    [[nodiscard]] bus::OpenedSocket open(const bus::SocketCanSettings&) override {
        ++attempts;
        if (missing) return {-1, bus::SocketFaultText("CAN interface 'can9': there is no such interface")};
        int ends[2] = {-1, -1};
        if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0, ends) != 0) return {};
        hang_up();
        far_ = ends[1];
        return {ends[0], {}};
    }
    [[nodiscard]] bus::SocketFaultText explain(const bus::SocketCanSettings&) override { return explanation; }
    [[nodiscard]] bool deliver(const bus::CanFrame& frame) const {
        std::array<unsigned char, bus::kKernelFdFrameBytes> record{};
        const std::size_t size = bus::frame_to_kernel(frame, record);
        return size > 0 && ::send(far_, record.data(), size, MSG_NOSIGNAL) == static_cast<ssize_t>(size);
    }
    /// An error frame as the kernel writes it: class bits of <linux/can/error.h>.
    void deliver_error(std::uint32_t class_bits) const {
        std::array<unsigned char, bus::kKernelFrameBytes> record{};
        const std::uint32_t id = 0x20000000u | class_bits;
        std::copy_n(reinterpret_cast<const unsigned char*>(&id), sizeof id, record.begin());
        record[4] = 8;
        ASSERT_EQ(::send(far_, record.data(), record.size(), MSG_NOSIGNAL), static_cast<ssize_t>(record.size()));
    }
    [[nodiscard]] bool receive(bus::CanFrame& frame) const {
        std::array<unsigned char, bus::kKernelFrameBytes> record{};
        const ssize_t size = ::recv(far_, record.data(), record.size(), MSG_DONTWAIT);
        return size == static_cast<ssize_t>(record.size()) && bus::frame_from_kernel(record, frame);
    }
    void hang_up() {
        if (far_ >= 0) close(far_);
        far_ = -1;
    }
    bool missing = false;
    bus::SocketFaultText explanation;  ///< what the system knows of the interface
    int attempts = 0;

private:
    int far_ = -1;
};

/// The embedded flight, handed out at the pace of the fake clock.
class EmbeddedFlight {
public:
    EmbeddedFlight() {
        bus::CandumpLogSource source(embedded_inputs().log);
        bus::CanFrame frame;
        while (source.read(base::Time{INT64_MAX}, base::Span<bus::CanFrame>(&frame, 1)) == 1) frames_.push_back(frame);
    }
    /// Sends what is due after the same time of the flight as has passed since the first call.
    void send_due(const PairPort& port) {
        if (next_ == 0) start_ns_ = FakeClock::now_ns;
        const std::int64_t first = frames_.front().time.ns;
        for (; next_ < frames_.size() && frames_[next_].time.ns - first <= FakeClock::now_ns - start_ns_; ++next_)
            ASSERT_TRUE(port.deliver(frames_[next_]));
    }
    [[nodiscard]] bool over() const { return next_ == frames_.size(); }
    [[nodiscard]] std::size_t size() const { return frames_.size(); }

private:
    std::vector<bus::CanFrame> frames_;
    std::size_t next_ = 0;
    std::int64_t start_ns_ = 0;
};

/// Lines written to it, each with its newline; no heap, so that it can serve under the heap trap.
struct LogLines {
    base::FixedString<8191> text;
    [[nodiscard]] EventLog log() {
        return {[](void* self, std::string_view line) { static_cast<LogLines*>(self)->text.append(line); }, this};
    }
    [[nodiscard]] std::string str() const { return std::string(text.view()); }
    [[nodiscard]] std::size_t lines() const {
        return static_cast<std::size_t>(std::count(text.view().begin(), text.view().end(), '\n'));
    }
};

inline BoardSettings board_settings() {
    const std::string board = test_support::source_dir() + "/tests/target/boards/fake_board.toml";
    auto settings = load_board_settings(board.c_str());
    EXPECT_TRUE(settings.ok()) << settings.error().message.view();
    return settings.ok() ? settings.value() : BoardSettings{};
}

}  // namespace tedavis::target
