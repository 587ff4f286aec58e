#include "platform/programs/new_program_folder.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

namespace tedavis::platform {
namespace {

base::Error cannot(std::string_view path, std::string_view what) {
    return base::make_error(path, ": ", what, " (", std::strerror(errno), "); check the folder above it and the free space");
}

}  // namespace

NewProgramFolder::~NewProgramFolder() {
    if (!is_open_) return;
    for (const std::uint64_t key : keys_) ::unlink(file_of(key).c_str());
    ::rmdir(part_.c_str());
}

NewProgramFolder::FilePath NewProgramFolder::file_of(std::uint64_t key) const {
    FilePath file(part_.view());
    file.append("/");
    file.append(program_file_name(key).view());
    return file;
}

base::Error NewProgramFolder::open(std::string_view path) {
    path_ = base::FixedString<1023>(path);
    part_ = path_;
    part_.append(".part");
    if (part_.cut()) return base::make_error("the path of the folder to write is longer than 1018 bytes; use a shorter one");
    struct stat found {};
    for (const char* const taken : {path_.c_str(), part_.c_str()})
        if (::stat(taken, &found) == 0) return base::make_error(taken, ": is there already; remove it or name another folder");
    room_.reset(new (std::nothrow) unsigned char[kMaxProgramBytes]);
    if (!room_) return base::make_error(path, ": no memory to write programs with; end other programs");
    if (::mkdir(part_.c_str(), 0755) != 0) return cannot(path, "cannot be made");
    is_open_ = true;
    return {};
}

base::Span<unsigned char> NewProgramFolder::room(std::size_t bytes) {
    if (bytes > kMaxProgramBytes) return {};
    return {room_.get(), bytes};
}

bool NewProgramFolder::keep(std::uint64_t key, std::string_view, const base::StoredProgram& program) {
    if (std::find(keys_.begin(), keys_.end(), key) != keys_.end()) return true;
    unsigned char header[kProgramHeaderBytes];
    write_program_header(key, program, header);
    std::FILE* const file = std::fopen(file_of(key).c_str(), "wbe");
    if (file == nullptr) return false;
    keys_.push_back(key);
    const bool is_written = std::fwrite(header, 1, sizeof header, file) == sizeof header &&
                            std::fwrite(program.binary.data(), 1, program.binary.size(), file) == program.binary.size() &&
                            std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0;
    return std::fclose(file) == 0 && is_written;
}

base::Error NewProgramFolder::commit() {
    if (std::rename(part_.c_str(), path_.c_str()) != 0) return cannot(path_.view(), "cannot be put in its place");
    is_open_ = false;
    return {};
}

}  // namespace tedavis::platform
