/// A program that reads records, as tests see it.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <string>
#include <vector>

namespace tedavis::target {

class RecordReader {
public:
    explicit RecordReader(const std::string& path) : descriptor_(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, path.c_str(), path.size());
        const void* const plain = &address;
        connected_ = ::connect(descriptor_, static_cast<const sockaddr*>(plain), sizeof address) == 0;
    }
    ~RecordReader() { ::close(descriptor_); }
    RecordReader(const RecordReader&) = delete;
    RecordReader& operator=(const RecordReader&) = delete;

    [[nodiscard]] bool is_connected() const { return connected_; }
    /// What has come, and no more than that.
    [[nodiscard]] std::vector<std::string> take_all() const {
        std::vector<std::string> all;
        std::vector<char> room(1 << 16);
        ssize_t size = 0;
        while ((size = ::recv(descriptor_, room.data(), room.size(), 0)) > 0)
            all.emplace_back(room.data(), static_cast<std::size_t>(size));
        return all;
    }
    /// The display has closed the connection.
    [[nodiscard]] bool is_turned_away() const {
        char byte = 0;
        return ::recv(descriptor_, &byte, 1, 0) == 0;
    }

private:
    int descriptor_;
    bool connected_ = false;
};

}  // namespace tedavis::target
