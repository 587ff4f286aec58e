#include "host_sim/flight_test/live_board.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kLargestRecord = 1 << 16;
constexpr std::int64_t kClockSecond_ns = 1'000'000'000;
constexpr int kSendTries = 200;  // a millisecond apart

base::Time live_monotonic() { return platform::monotonic_now(); }

base::Time live_wall() {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return {static_cast<std::int64_t>(now.tv_sec) * kClockSecond_ns + now.tv_nsec};
}

timespec timespec_of(base::Duration duration) {
    const std::int64_t ns = std::max<std::int64_t>(duration.ns, 0);
    return {static_cast<time_t>(ns / kClockSecond_ns), static_cast<long>(ns % kClockSecond_ns)};
}

}  // namespace

LiveBoard::LiveBoard(const LiveBoardOptions& options, const bus::SwitchConfig& panel, bus::CanSocketPort& can)
    : options_(options), can_port_(can), packet_(kLargestRecord) {
    open_bus();
    if (!options.panel_lines.empty()) find_lines(panel);
    connect_display();
}

LiveBoard::~LiveBoard() {
    if (display_ >= 0) ::close(display_);
}

void LiveBoard::connect_display() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (options_.socket.size() >= sizeof address.sun_path)
        throw UserError("--target " + options_.socket + ": is longer than the name of a socket may be");
    std::memcpy(address.sun_path, options_.socket.data(), options_.socket.size());
    display_ = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const void* const plain = &address;
    if (display_ >= 0 && ::connect(display_, static_cast<const sockaddr*>(plain), sizeof address) == 0) return;
    const int error = errno;
    const std::string why = std::strerror(error);
    if (display_ >= 0) ::close(display_);
    display_ = -1;
    const bool is_forbidden = error == EACCES || error == EPERM;
    throw UserError("--target " + options_.socket + ": no display hands out records there: " + why +
                    (is_forbidden ? "; run this as the display's user or group"
                                  : "; start tedavis-display with this path under [records], or name the path that it has"));
}

void LiveBoard::refuse_bus(const std::string& otherwise) {
    const bus::SocketFaultText why = can_port_.explain(can_settings_);
    throw BoardLost(why.empty() ? "CAN interface '" + options_.interface + "': " + otherwise : std::string(why.view()));
}

void LiveBoard::open_bus() {
    if (options_.interface.empty() || options_.interface.size() > 15)
        throw UserError("--interface " + options_.interface + ": is no name of a CAN interface; say the board's, such as can0");
    can_settings_.interface_name = base::FixedString<15>(options_.interface);
    can_settings_.can_fd = options_.can_fd;
    if (const bus::SocketFaultText why = can_port_.explain(can_settings_); !why.empty()) throw UserError(std::string(why.view()));
    can_ = std::make_unique<bus::SocketCanSource>(can_port_, can_settings_, bus::LiveClocks{&live_monotonic, &live_wall});
    drain_bus();
    if (can_->descriptor() >= 0) return;
    const std::string_view fault = can_->last_fault();
    refuse_bus(fault.empty() ? "cannot be opened; see `ip -details link show`" : std::string(fault));
}

void LiveBoard::find_lines(const bus::SwitchConfig& panel) {
    for (std::size_t n = 0; n < panel.lines.size(); ++n) {
        const bus::SwitchLine& line = panel.lines[n];
        const std::string number = std::to_string(line.offset >= 0 ? static_cast<std::size_t>(line.offset) : n);
        pulls_.push_back({options_.panel_lines + "/sim_gpio" + number + "/pull", line.active_low});
        if (::access(pulls_.back().path.c_str(), W_OK) == 0) continue;
        throw UserError("--panel-lines " + options_.panel_lines + ": the line '" + std::string(line.name.view()) +
                        "' of the panel cannot be pulled: " + pulls_.back().path + ": " + std::strerror(errno) +
                        "; name the folder of a gpio-sim chip in /sys/devices/platform, and run this as root");
    }
}

void LiveBoard::set_line(std::size_t line, bool level) {
    const Pull& pull = pulls_[line];
    const std::string_view word = level != pull.active_low ? "pull-up" : "pull-down";
    const int file = ::open(pull.path.c_str(), O_WRONLY | O_CLOEXEC);
    const bool is_written = file >= 0 && ::write(file, word.data(), word.size()) == static_cast<ssize_t>(word.size());
    const std::string why = is_written ? "" : std::strerror(errno);
    if (file >= 0) ::close(file);
    if (!is_written) throw BoardLost(pull.path + ": cannot be pulled: " + why + "; make the panel's chip again, and start again");
}

base::Time LiveBoard::now() { return live_monotonic(); }

/// What others send must not fill the socket.
void LiveBoard::drain_bus() {
    std::array<bus::CanFrame, 64> others;
    std::size_t count = 0;
    do {
        count = can_->read(live_monotonic(), {others.data(), others.size()});
        if (keeps_received_)
            received_.insert(received_.end(), others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count));
    } while (count == others.size());
}

std::vector<bus::CanFrame> LiveBoard::take_received() {
    keeps_received_ = true;
    drain_bus();
    return std::exchange(received_, {});
}

std::optional<std::string> LiveBoard::next_record(base::Time until) {
    for (;;) {
        std::array<pollfd, 2> files{pollfd{display_, POLLIN, 0}, pollfd{can_->descriptor(), POLLIN, 0}};
        const timespec wait = timespec_of(until - live_monotonic());
        const int ready = ::ppoll(files.data(), files.size(), &wait, nullptr);
        if (files[1].revents != 0) drain_bus();
        if (ready <= 0 || files[0].revents == 0) {
            if (live_monotonic() >= until || ready < 0) return std::nullopt;
            continue;
        }
        const ssize_t size = ::recv(display_, packet_.data(), packet_.size(), 0);
        if (size > 0) return std::string(packet_.data(), static_cast<std::size_t>(size));
        if (size < 0 && (errno == EAGAIN || errno == EINTR)) continue;
        throw BoardLost(options_.socket +
                        ": the display is gone, or has turned this reader away; start it again, or end other "
                        "readers, and fly the test again");
    }
}

/// A full queue empties as fast as the bus takes frames.
void LiveBoard::send(const bus::CanFrame& frame) {
    if (frame.kind == bus::FrameKind::fd && !options_.can_fd)
        throw UserError(
            "the input has a CAN FD frame, and the board's bus takes none; say fd = true under [can] of the board file");
    for (int n = 0; n < kSendTries; ++n) {
        if (can_->send(frame)) return;
        const timespec millisecond{0, 1'000'000};
        ::nanosleep(&millisecond, nullptr);
        drain_bus();
    }
    refuse_bus(
        "takes no frame: its queue is full; see that another node acknowledges frames, and make the queue longer "
        "(`ip link set " +
        options_.interface + " txqueuelen 1000`)");
}

}  // namespace tedavis::host_sim
