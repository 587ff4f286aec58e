#include "target/watchdog.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace tedavis::target {

Watchdog::Watchdog() {
    if (const char* path = std::getenv("NOTIFY_SOCKET")) connect_to(path);
    if (const char* limit = std::getenv("WATCHDOG_USEC")) std::from_chars(limit, limit + std::strlen(limit), limit_us_);
}

Watchdog::Watchdog(std::string_view socket_path, std::uint64_t limit_us) : limit_us_(limit_us) { connect_to(socket_path); }

Watchdog::~Watchdog() {
    if (descriptor_ >= 0) close(descriptor_);
}

void Watchdog::connect_to(std::string_view socket_path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (socket_path.empty() || socket_path.size() >= sizeof address.sun_path) return;
    std::memcpy(address.sun_path, socket_path.data(), socket_path.size());
    if (address.sun_path[0] == '@') address.sun_path[0] = '\0';
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + socket_path.size());
    descriptor_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const void* plain = &address;
    if (descriptor_ < 0 || connect(descriptor_, static_cast<const sockaddr*>(plain), size) == 0) return;
    close(descriptor_);
    descriptor_ = -1;
}

void Watchdog::ready() {
    expect_slow_frames();
    send("READY=1\nSTATUS=displaying\n");
}

void Watchdog::expect_slow_frames() {
    quick_frames_ = 0;
    if (!is_patient_) set_limit(kPatience_us);
    is_patient_ = true;
}

void Watchdog::alive(base::Duration took) {
    send("WATCHDOG=1\n");
    quick_frames_ = took < kQuick ? quick_frames_ + 1 : 0;
    if (!is_patient_ || quick_frames_ < kQuickFrames) return;
    is_patient_ = false;
    set_limit(limit_us_);
}

/// A manager that waits as long by itself is told nothing.
void Watchdog::set_limit(std::uint64_t limit_us) const {
    if (limit_us_ == 0 || limit_us_ >= kPatience_us) return;
    char text[40];
    const int size = std::snprintf(text, sizeof text, "WATCHDOG_USEC=%llu\n", static_cast<unsigned long long>(limit_us));
    send({text, static_cast<std::size_t>(size)});
}

void Watchdog::send(std::string_view message) const {
    if (descriptor_ < 0) return;
    // A manager that does not read must not hold the display.
    if (::send(descriptor_, message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL) < 0) return;
}

}  // namespace tedavis::target
