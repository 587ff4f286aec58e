/// Frames from a live bus.
///
/// Reading never blocks, and takes what waits in the kernel in batches: a full bus brings thousands of frames a second. Kernel
/// stamps are wall-clock time and are converted once, at reading, to the monotonic clock. A stamp that the conversion puts into
/// the future (the clock was set back) is replaced by the time of reading; one that it puts more than two seconds into the past
/// (the program was halted, or the clock was set forward) by two seconds before it. Frames that the kernel drops are counted by
/// its own counter. Bus-off and link-down are reported by health(); a socket that fails is closed and opened again, at most once
/// in `reopen_interval`.
///
/// health() and the count of error frames are those of what was received, which may be a batch ahead of what read() returned.
///
/// Thread  one. Memory  fixed, and 20 KiB of the stack while reading. Failure  health() and last_fault().
#pragma once

#include <array>

#include "bus/frame/can_source.hpp"
#include "bus/socketcan/can_socket_port.hpp"

namespace tedavis::bus {

/// The machine's two clocks, provided by the composition root.
struct LiveClocks {
    base::Time (*monotonic)() = nullptr;
    base::Time (*wall)() = nullptr;
};

class SocketCanSource final : public CanSource {
public:
    /// Opens at the first read. The port must outlive the source.
    SocketCanSource(CanSocketPort& port, const SocketCanSettings& settings, LiveClocks clocks);
    ~SocketCanSource() override;
    SocketCanSource(const SocketCanSource&) = delete;
    SocketCanSource& operator=(const SocketCanSource&) = delete;

    /// Times are those of the monotonic clock; `until` is normally its current time.
    [[nodiscard]] std::size_t read(base::Time until, base::Span<CanFrame> out) override;
    [[nodiscard]] SourceHealth health() const override { return health_; }
    [[nodiscard]] const SourceStatistics& statistics() const override { return statistics_; }
    /// One sentence why the socket is not open; empty while it is open.
    [[nodiscard]] std::string_view last_fault() const { return fault_.view(); }

    /// Hands one frame to the kernel. Returns false, and the frame is dropped, when the kernel's queue is full or there is no
    /// bus.
    [[nodiscard]] bool send(const CanFrame& frame);
    /// The descriptor for the composition root's poll; -1 while closed.
    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    static constexpr std::size_t kMaxBatch = 64;  ///< records of one system call
    struct Records;
    struct Stamp {
        base::Time wall;
        bool present = false;
    };
    [[nodiscard]] bool ensure_open(base::Time now);
    /// Into the batch; false where nothing has come.
    [[nodiscard]] bool receive();
    void take_record(base::Span<const unsigned char> bytes, void* message);
    [[nodiscard]] Stamp read_ancillary(void* message);
    [[nodiscard]] base::Time monotonic_time(Stamp stamp) const;
    void record_failure(int error);
    void record_error_frame(const CanFrame& frame);
    void count_kernel_drops(std::uint32_t total);
    void close_socket();

    CanSocketPort& port_;
    SocketCanSettings settings_;
    LiveClocks clocks_;
    int descriptor_ = -1;
    SourceHealth health_ = SourceHealth::idle;
    SourceStatistics statistics_;
    SocketFaultText fault_;
    base::Time last_attempt_;
    bool attempted_ = false;
    bool opened_before_ = false;
    std::uint32_t kernel_drops_ = 0;         // the socket's cumulative counter as last seen
    std::array<CanFrame, kMaxBatch> batch_;  // received, and from `batch_next_` on not given to the caller yet
    std::size_t batch_next_ = 0, batch_end_ = 0;
};

}  // namespace tedavis::bus
