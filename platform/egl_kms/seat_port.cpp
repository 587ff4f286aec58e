#include "platform/egl_kms/seat_port.hpp"

#if defined(TEDAVIS_HAVE_SEAT)

// Its header is for C alone.
extern "C" {
#include <libseat.h>
}
#include <poll.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>

#include "render_core/base/driver_scope.hpp"

namespace tedavis::platform {
namespace {

// libseat names the backend in its log alone, and its log is the process's.
base::FixedString<31> opened_backend;

void read_backend(libseat_log_level, const char* format, va_list parts) {
    if (std::strstr(format, "Seat opened with backend") == nullptr) return;
    char line[256];
    if (std::vsnprintf(line, sizeof line, format, parts) < 0) return;
    const std::string_view text(line);
    const std::size_t begin = text.find('\''), end = text.rfind('\'');
    if (begin != std::string_view::npos && end > begin + 1) opened_backend = text.substr(begin + 1, end - begin - 1);
}

SeatListener& listener_of(void* self) { return *static_cast<SeatListener*>(self); }

constexpr libseat_seat_listener kEvents = {[](libseat*, void* self) { listener_of(self).on_enable(); },
                                           [](libseat*, void* self) { listener_of(self).on_disable(); }};

class LibseatPort final : public SeatPort {
public:
    LibseatPort() = default;
    ~LibseatPort() override { close(); }
    LibseatPort(const LibseatPort&) = delete;
    LibseatPort& operator=(const LibseatPort&) = delete;

    bool open(SeatListener& listener) override {
        const base::DriverScope driver;
        opened_backend = "";
        libseat_set_log_handler(&read_backend);
        libseat_set_log_level(LIBSEAT_LOG_LEVEL_INFO);
        seat_ = libseat_open_seat(&kEvents, &listener);
        libseat_set_log_level(LIBSEAT_LOG_LEVEL_SILENT);
        manager_ = opened_backend;
        // Where each manager refuses, libseat manages the terminal itself, and other programs would not know of it.
        if (manager_.view() == "builtin" && std::getenv("LIBSEAT_BACKEND") == nullptr) close();
        return seat_ != nullptr;
    }
    int open_device(const char* path, int& descriptor) override {
        const base::DriverScope driver;
        return libseat_open_device(seat_, path, &descriptor);
    }
    void close_device(int device) override {
        const base::DriverScope driver;
        libseat_close_device(seat_, device);
    }
    bool disable() override {
        const base::DriverScope driver;
        return libseat_disable_seat(seat_) == 0;
    }
    bool dispatch(int wait_ms) override {
        const base::DriverScope driver;
        if (libseat_dispatch(seat_, wait_ms) < 0) return false;
        const int file = libseat_get_fd(seat_);
        if (file < 0) return false;  // sd-bus has closed the connection to logind, and poll() ignores such a file
        // Without a wait libseat 0.7 takes a connection that was closed for one on which nothing came.
        pollfd connection{file, POLLIN, 0};
        return ::poll(&connection, 1, 0) <= 0 || (connection.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
    }
    void close() override {
        const base::DriverScope driver;
        if (seat_ != nullptr) libseat_close_seat(seat_);
        seat_ = nullptr;
    }
    base::FixedString<31> manager() const override { return manager_; }

private:
    libseat* seat_ = nullptr;
    base::FixedString<31> manager_;
};

}  // namespace

std::unique_ptr<SeatPort> make_libseat_port() { return std::unique_ptr<SeatPort>(new (std::nothrow) LibseatPort()); }

}  // namespace tedavis::platform

#else

namespace tedavis::platform {

std::unique_ptr<SeatPort> make_libseat_port() { return nullptr; }

}  // namespace tedavis::platform

#endif
