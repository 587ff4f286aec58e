#include "bus/socketcan/socketcan_source.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>

#include "bus/socketcan/kernel_frame.hpp"

namespace tedavis::bus {
namespace {

constexpr base::Duration kOldestBelievable = base::Duration::seconds(2);
constexpr std::size_t kControlBytes = CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t)) + 64;

base::Time time_of(const timespec& stamp) { return {static_cast<std::int64_t>(stamp.tv_sec) * 1'000'000'000 + stamp.tv_nsec}; }

}  // namespace

SocketCanSource::SocketCanSource(CanSocketPort& port, const SocketCanSettings& settings, LiveClocks clocks)
    : port_(port), settings_(settings), clocks_(clocks) {
    TEDAVIS_CHECK(clocks.monotonic != nullptr && clocks.wall != nullptr);
}

SocketCanSource::~SocketCanSource() { close_socket(); }

void SocketCanSource::close_socket() {
    if (descriptor_ >= 0) close(descriptor_);
    descriptor_ = -1;
    kernel_drops_ = 0;
}

bool SocketCanSource::ensure_open(base::Time now) {
    if (descriptor_ >= 0) return true;
    if (attempted_ && now - last_attempt_ < settings_.reopen_interval) return false;
    attempted_ = true;
    last_attempt_ = now;
    const OpenedSocket opened = port_.open(settings_);
    if (opened.descriptor < 0) {
        health_ = SourceHealth::failed;
        fault_ = opened.reason;
        return false;
    }
    descriptor_ = opened.descriptor;
    fault_.clear();
    health_ = SourceHealth::idle;
    if (opened_before_) ++statistics_.reopened;
    opened_before_ = true;
    return true;
}

std::size_t SocketCanSource::read(base::Time until, base::Span<CanFrame> out) {
    std::size_t count = 0;
    // Batches without a frame use up turns too: a flood of other records holds the caller for out.size() batches at most.
    for (std::size_t turn = 0; turn < out.size(); ++turn) {
        if (batch_next_ == batch_end_ && (!ensure_open(until) || !receive())) break;
        if (batch_next_ == batch_end_) continue;
        if (batch_[batch_next_].time > until) break;
        out[count++] = batch_[batch_next_++];
        ++statistics_.frames;
    }
    return count;
}

/// Where the kernel writes the records of one call.
struct SocketCanSource::Records {
    std::array<std::array<unsigned char, kKernelFdFrameBytes + 1>, kMaxBatch> bytes;
    alignas(cmsghdr) std::array<std::array<unsigned char, kControlBytes>, kMaxBatch> control;
    std::array<iovec, kMaxBatch> places;
    std::array<mmsghdr, kMaxBatch> messages;

    Records() {
        for (std::size_t n = 0; n < kMaxBatch; ++n) {
            places[n] = {bytes[n].data(), bytes[n].size()};
            messages[n] = {};
            messages[n].msg_hdr.msg_iov = &places[n];
            messages[n].msg_hdr.msg_iovlen = 1;
            messages[n].msg_hdr.msg_control = control[n].data();
            messages[n].msg_hdr.msg_controllen = control[n].size();
        }
    }
};

bool SocketCanSource::receive() {
    Records records;
    batch_next_ = batch_end_ = 0;
    const int count = recvmmsg(descriptor_, records.messages.data(), kMaxBatch, MSG_DONTWAIT, nullptr);
    if (count < 0) {
        if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) record_failure(errno);
        return false;
    }
    for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
        mmsghdr& message = records.messages[n];
        if (message.msg_len == 0) {
            // The end of the socket; after what came before it, the next call finds the end again.
            if (n == 0) record_failure(ENODEV);
            return n > 0;
        }
        take_record({records.bytes[n].data(), message.msg_len}, &message.msg_hdr);
    }
    return count > 0;
}

void SocketCanSource::take_record(base::Span<const unsigned char> bytes, void* opaque) {
    auto* message = static_cast<msghdr*>(opaque);
    CanFrame& frame = batch_[batch_end_];
    frame = CanFrame();
    frame.time = monotonic_time(read_ancillary(message));
    if (!frame_from_kernel(bytes, frame)) {
        ++statistics_.malformed;
        return;
    }
    frame.transmitted = (message->msg_flags & MSG_DONTROUTE) != 0;
    if (frame.kind == FrameKind::error)
        record_error_frame(frame);
    else
        health_ = SourceHealth::running;
    ++batch_end_;
}

SocketCanSource::Stamp SocketCanSource::read_ancillary(void* opaque) {
    auto* message = static_cast<msghdr*>(opaque);
    Stamp stamp;
    for (cmsghdr* part = CMSG_FIRSTHDR(message); part != nullptr; part = CMSG_NXTHDR(message, part)) {
        if (part->cmsg_level != SOL_SOCKET) continue;
        if (part->cmsg_type == SCM_TIMESTAMPNS) {
            timespec wall{};
            std::memcpy(&wall, CMSG_DATA(part), sizeof wall);
            stamp = {time_of(wall), true};
        } else if (part->cmsg_type == SO_RXQ_OVFL) {
            std::uint32_t total = 0;
            std::memcpy(&total, CMSG_DATA(part), sizeof total);
            count_kernel_drops(total);
        }
    }
    return stamp;
}

/// The kernel's counter is cumulative and 32 bits wide; the difference survives its wrap.
void SocketCanSource::count_kernel_drops(std::uint32_t total) {
    statistics_.dropped += static_cast<std::uint32_t>(total - kernel_drops_);
    kernel_drops_ = total;
}

/// A frame that seems to have waited longer than can be believed is as old as can be: after a halt of the program the socket is
/// full of frames that are not current, and none of them may pass for a new one.
base::Time SocketCanSource::monotonic_time(Stamp stamp) const {
    const base::Time now = clocks_.monotonic();
    if (!stamp.present) return now;
    const base::Duration age = clocks_.wall() - stamp.wall;
    if (age < base::Duration{}) return now;
    return now - (age > kOldestBelievable ? kOldestBelievable : age);
}

void SocketCanSource::record_error_frame(const CanFrame& frame) {
    ++statistics_.error_frames;
    const ControllerEvent event = controller_event(frame);
    if (event == ControllerEvent::bus_off) health_ = SourceHealth::bus_off;
    if (event == ControllerEvent::restarted) health_ = SourceHealth::running;
    if (event == ControllerEvent::overflow) ++statistics_.dropped;
}

/// ENETDOWN leaves the socket bound: frames come again when the link does. Anything else needs a new socket.
void SocketCanSource::record_failure(int error) {
    if (error == ENETDOWN) {
        health_ = SourceHealth::link_down;
        return;
    }
    close_socket();
    health_ = SourceHealth::failed;
    fault_ = SocketFaultText("CAN interface '");
    fault_.append(settings_.interface_name.view());
    fault_.append("' went away; it is opened again when it is back");
}

bool SocketCanSource::send(const CanFrame& frame) {
    std::array<unsigned char, kKernelFdFrameBytes> bytes{};
    const std::size_t size = frame_to_kernel(frame, bytes);
    if (size == 0 || descriptor_ < 0) return false;
    return ::send(descriptor_, bytes.data(), size, MSG_DONTWAIT | MSG_NOSIGNAL) == static_cast<ssize_t>(size);
}

}  // namespace tedavis::bus
