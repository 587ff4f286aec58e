#include "target/new_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace tedavis::target {
namespace {

base::Error cannot(const Path& path, std::string_view what, std::string_view advice) {
    return base::make_error(path.view(), ": ", what, " (", std::strerror(errno), "); ", advice);
}

}  // namespace

NewFile::~NewFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(part_.c_str());
}

base::Error NewFile::open(const char* path) {
    path_ = path;
    part_ = path;
    part_.append(".part");
    if (part_.cut()) return base::make_error("the path of the file to write is longer than 1018 bytes; use a shorter one");
    struct stat found {};
    if (::stat(path, &found) == 0 && !S_ISREG(found.st_mode))
        return base::make_error(path, ": is no regular file and would be replaced; name a file to write");
    descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    return descriptor_ < 0 ? cannot(path_, "cannot be written", "check the folder and its permissions") : base::Error();
}

base::Error NewFile::write_all(std::string_view text) const {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor_, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return cannot(path_, "could not be written to its end", "check the free space");
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor_) == 0 ? base::Error() : cannot(path_, "could not be written to its end", "check the medium");
}

base::Error NewFile::write(std::string_view text) {
    if (base::Error error = write_all(text)) return error;
    if (std::rename(part_.c_str(), path_.c_str()) != 0) return cannot(path_, "cannot be put in its place", "check the folder");
    ::close(descriptor_);
    descriptor_ = -1;
    return {};
}

}  // namespace tedavis::target
