#include "target/watchdog.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace tedavis::target {

Watchdog::Watchdog() {
    if (const char* path = std::getenv("NOTIFY_SOCKET")) connect_to(path);
}

Watchdog::Watchdog(std::string_view socket_path) { connect_to(socket_path); }

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

void Watchdog::send(std::string_view message) const {
    if (descriptor_ < 0) return;
    // A manager that does not read must not hold the display.
    if (::send(descriptor_, message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL) < 0) return;
}

}  // namespace tedavis::target
