#include "platform/egl_kms/seat_offer.hpp"

#include <grp.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "render_core/base/error.hpp"

namespace tedavis::platform {
namespace {

/// 0 where somebody listens there, else the errno. Never waits.
int connection_fault(const char* path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (std::strlen(path) >= sizeof address.sun_path) return ENAMETOOLONG;
    std::memcpy(address.sun_path, path, std::strlen(path));
    const int file = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (file < 0) return errno;
    const int fault = ::connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? 0 : errno;
    ::close(file);
    return fault;
}

base::FixedString<31> group_of_socket(const char* path) {
    struct stat file {};
    if (::stat(path, &file) != 0) return {};
    const group* const owner = ::getgrgid(file.st_gid);
    return owner != nullptr ? base::FixedString<31>(owner->gr_name) : base::FixedString<31>(base::digits(file.st_gid).view());
}

SeatOffer offer_of_seatd(const char* socket) {
    const int fault = connection_fault(socket);
    if (fault == 0) return {true, base::make_error("seatd at ", socket).message.view()};
    if (fault == ENOENT || fault == ENOTDIR || fault == ECONNREFUSED) return {};
    if (fault != EACCES) return {false, base::make_error(socket, ": ", std::strerror(fault)).message.view()};
    const base::FixedString<31> group = group_of_socket(socket);
    return {false,
            base::make_error("seatd runs, but this user may not reach it (", socket, ": Permission denied); ", "`usermod -aG ",
                             group.empty() ? std::string_view("GROUP") : group.view(), " USER`, then log in again")
                .message.view()};
}

}  // namespace

SeatSigns machine_seat_signs() {
    SeatSigns signs;
    signs.backend = std::getenv("LIBSEAT_BACKEND");
    signs.session = std::getenv("XDG_SEAT");
    signs.socket = std::getenv("SEATD_SOCK");
    if (signs.socket == nullptr) signs.socket = "/run/seatd.sock";
    signs.is_root = ::geteuid() == 0;
    return signs;
}

SeatOffer find_seat(const SeatSigns& signs) {
    if (!can_use_seats()) return {false, "this build uses no seat managers, since libseat was missing"};
    // libseat takes an empty name for one, too, and knows no such backend.
    if (signs.backend != nullptr && *signs.backend == '\0') return {false, "LIBSEAT_BACKEND is set and empty; unset it"};
    if (signs.backend != nullptr) return {true, base::make_error(signs.backend, " (by LIBSEAT_BACKEND)").message.view()};
    if (signs.is_root) return {false, "root asks a seat manager only where LIBSEAT_BACKEND names one"};
    const SeatOffer seatd = offer_of_seatd(signs.socket);
    if (seatd.is_there || signs.session == nullptr || *signs.session == '\0') return seatd;
    return {true, base::make_error("logind (session on ", signs.session, ")").message.view()};
}

bool can_use_seats() {
#if defined(TEDAVIS_HAVE_SEAT)
    return true;
#else
    return false;
#endif
}

}  // namespace tedavis::platform
