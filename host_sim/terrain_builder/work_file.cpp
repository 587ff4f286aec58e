#include "host_sim/terrain_builder/work_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

WorkFile::WorkFile(std::string path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail("opened");
}

WorkFile WorkFile::existing(std::string path) {
    WorkFile file;
    file.path_ = std::move(path);
    file.descriptor_ = ::open(file.path_.c_str(), O_RDONLY | O_CLOEXEC);
    if (file.descriptor_ < 0) throw UserError(file.path_ + ": cannot be read (" + std::strerror(errno) + "); check the name");
    return file;
}

WorkFile::~WorkFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

WorkFile::WorkFile(WorkFile&& other) noexcept { *this = std::move(other); }

WorkFile& WorkFile::operator=(WorkFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    changed_ = other.changed_.exchange(changed_);
    return *this;
}

void WorkFile::read(std::uint64_t offset, void* destination, std::size_t count) const {
    auto* out = static_cast<unsigned char*>(destination);
    while (count > 0) {
        const ssize_t got = ::pread(descriptor_, out, count, static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got == 0) errno = ENODATA;
        if (got <= 0) fail("read");
        out += got;
        offset += static_cast<std::uint64_t>(got);
        count -= static_cast<std::size_t>(got);
    }
}

void WorkFile::write(std::uint64_t offset, const void* source, std::size_t count) {
    const auto* in = static_cast<const unsigned char*>(source);
    changed_ = true;
    while (count > 0) {
        const ssize_t put = ::pwrite(descriptor_, in, count, static_cast<off_t>(offset));
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) fail("written");
        in += put;
        offset += static_cast<std::uint64_t>(put);
        count -= static_cast<std::size_t>(put);
    }
}

void WorkFile::resize(std::uint64_t bytes) {
    changed_ = true;
    if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) fail("written");
}

void WorkFile::sync() {
    if (changed_.exchange(false) && ::fdatasync(descriptor_) != 0) fail("written");
}

std::uint64_t WorkFile::size() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail("read");
    return static_cast<std::uint64_t>(status.st_size);
}

void WorkFile::fail(const char* what) const {
    throw WorkFileError(path_ + ": cannot be " + what + " (" + std::strerror(errno) +
                        "); check the folder and the free space, then give the same command again");
}

}  // namespace tedavis::host_sim
