#include "platform/files/file_byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace tedavis::platform {
namespace {

/// Of the call that failed last.
base::Error file_error(const char* path) {
    const int reason = errno;
    base::Error error = base::make_error(path, ": cannot be read (", std::strerror(reason));
    error.message.append(reason == ENOENT || reason == ENOTDIR ? "); check the path"
                         : reason == EACCES                    ? "); check its permissions"
                                                               : "); check the medium that holds it");
    return error;
}

/// A signal may interrupt a read; more often than this in one read is a broken machine.
constexpr int kMaxInterruptions = 1000;

}  // namespace

FileByteSource::~FileByteSource() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

FileByteSource::FileByteSource(FileByteSource&& other) noexcept { *this = std::move(other); }

FileByteSource& FileByteSource::operator=(FileByteSource&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    std::swap(size_, other.size_);
    return *this;
}

bool FileByteSource::read(std::uint64_t offset, void* destination, std::size_t count) {
    if (descriptor_ < 0 || count > size_ || offset > size_ - count) return false;
    auto* out = static_cast<unsigned char*>(destination);
    int interruptions = 0;
    while (count > 0) {
        const ssize_t got = ::pread(descriptor_, out, count, static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR && ++interruptions < kMaxInterruptions) continue;
        if (got <= 0) return false;
        out += got;
        offset += static_cast<std::uint64_t>(got);
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

base::Result<FileByteSource, base::Error> open_file(const char* path) {
    FileByteSource source;
    source.descriptor_ = ::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (source.descriptor_ < 0) return base::fail(file_error(path));
    struct stat status {};
    if (::fstat(source.descriptor_, &status) != 0) return base::fail(file_error(path));
    if (!S_ISREG(status.st_mode)) return base::fail(base::make_error(path, ": is not a regular file; name one"));
    source.size_ = static_cast<std::uint64_t>(status.st_size);
    return source;
}

}  // namespace tedavis::platform
