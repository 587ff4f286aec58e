#include "target/record_socket.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace tedavis::target {
namespace {

constexpr const char* kKey = "[records] socket '";

struct Address {
    sockaddr_un value{};

    explicit Address(const Path& path) {
        value.sun_family = AF_UNIX;
        std::memcpy(value.sun_path, path.c_str(), path.size());
    }
    [[nodiscard]] const sockaddr* get() const {
        const void* const plain = &value;
        return static_cast<const sockaddr*>(plain);
    }
};

int packet_socket() { return ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0); }

/// Whether it is known that no program listens there: one of another kind, or of another user, is not ours to remove.
bool is_left(const Address& address) {
    const int caller = packet_socket();
    const bool is_refused = caller >= 0 && ::connect(caller, address.get(), sizeof address.value) != 0 && errno == ECONNREFUSED;
    if (caller >= 0) ::close(caller);
    return is_refused;
}

/// Takes a socket away that nobody serves.
base::Error clear_place(const Path& path, const Address& address) {
    struct stat found {};
    if (::lstat(path.c_str(), &found) != 0) return {};
    if (!S_ISSOCK(found.st_mode))
        return base::make_error({kKey, path.view(), "': is a file of another kind; name another place"});
    if (!is_left(address))
        return base::make_error({kKey, path.view(), "': is in use by another program; stop that one, or name another place"});
    if (::unlink(path.c_str()) == 0) return {};
    return base::make_error({kKey, path.view(), "': was left by an ended program and cannot be removed: ", std::strerror(errno),
                             "; remove it, or name another place"});
}

}  // namespace

RecordSocket::~RecordSocket() {
    for (std::size_t n = 0; n < count_; ++n) ::close(readers_[n].descriptor);
    if (!is_started()) return;
    ::close(listener_);
    ::unlink(path_.c_str());
}

base::Error RecordSocket::start(const Path& path) {
    if (path.cut() || path.size() >= sizeof sockaddr_un{}.sun_path)
        return base::make_error({kKey, path.view(), "': is longer than the name of a socket may be; choose a shorter path"});
    listener_ = packet_socket();
    base::Error error = listener_ < 0
                            ? base::make_error({kKey, path.view(), "': the system gives no socket: ", std::strerror(errno),
                                                "; end other programs and start again"})
                            : bind_at(path);
    if (error && listener_ >= 0) {
        ::close(listener_);
        listener_ = -1;
    }
    return error;
}

base::Error RecordSocket::bind_at(const Path& path) {
    const Address address(path);
    if (base::Error error = clear_place(path, address)) return error;
    if (::bind(listener_, address.get(), sizeof address.value) != 0)
        return base::make_error({kKey, path.view(), "': cannot be made: ", std::strerror(errno),
                                 "; name a folder that exists and that the program may write to"});
    ::chmod(path.c_str(), S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP);
    path_ = path;
    if (::listen(listener_, static_cast<int>(kMaxReaders)) == 0) return {};
    ::unlink(path.c_str());
    return base::make_error({kKey, path.view(), "': cannot be listened at: ", std::strerror(errno), "; name another place"});
}

bool RecordSocket::has_readers() {
    if (!is_started()) return false;
    // At most as many in one frame as may be there.
    for (std::size_t n = 0; n < kMaxReaders; ++n) {
        const int reader = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (reader < 0) break;
        if (count_ == kMaxReaders)
            ::close(reader);
        else
            readers_[count_++] = {reader, 0};
    }
    return count_ > 0;
}

bool RecordSocket::takes(Reader& reader, std::string_view record) {
    if (::send(reader.descriptor, record.data(), record.size(), MSG_DONTWAIT | MSG_NOSIGNAL) >= 0) {
        reader.missed = 0;
        return true;
    }
    const bool is_full = errno == EAGAIN || errno == EWOULDBLOCK || errno == ENOBUFS;
    return is_full && ++reader.missed < kMaxMissed;
}

void RecordSocket::send(std::string_view record) {
    for (std::size_t n = 0; n < count_;) {
        if (takes(readers_[n], record)) {
            ++n;
            continue;
        }
        ::close(readers_[n].descriptor);
        readers_[n] = readers_[--count_];
    }
}

}  // namespace tedavis::target
