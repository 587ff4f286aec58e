#include "host_sim/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), part_(path_ + ".part") {
    std::error_code ignored;
    if (std::filesystem::is_directory(path_, ignored)) throw UserError(path_ + ": is a folder; name a file to write");
    if (std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored))
        throw UserError(path_ + ": is a device or a pipe, which would be replaced; name a file to write");
    stream_.open(part_, std::ios::binary | std::ios::trunc);
    if (!stream_) throw UserError(path_ + ": cannot be written (" + std::strerror(errno) + "); check the folder");
}

AtomicFile::~AtomicFile() {
    if (committed_) return;
    stream_.close();
    std::remove(part_.c_str());
}

void AtomicFile::seal() {
    if (sealed_) return;
    stream_.close();
    if (!stream_) throw UserError(path_ + ": could not be written to its end; check the free space");
    sealed_ = true;
}

void AtomicFile::commit() {
    seal();
    if (std::rename(part_.c_str(), path_.c_str()) != 0) {
        throw UserError(path_ + ": cannot be put in its place (" + std::strerror(errno) + "); check the folder");
    }
    committed_ = true;
}

void write_file_atomically(const std::string& path, std::string_view text) {
    AtomicFile file(path);
    file.stream() << text;
    file.commit();
}

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw UserError(path + ": this folder cannot be made (" + error.message() + "); name another one");
    if (!std::filesystem::is_directory(path, error))
        throw UserError(path + ": this folder cannot be made (a file has its name); name another one");
}

}  // namespace tedavis::host_sim
