/// A file for intermediate and final results: positioned reads and writes of whole pieces, from any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

/// The disk failed or is full: with that mended, the same work can go on.
class WorkFileError : public UserError {
public:
    using UserError::UserError;
};

class WorkFile {
public:
    WorkFile() = default;
    /// Opens it for reading and writing; makes it where it does not exist. Throws UserError.
    explicit WorkFile(std::string path);
    /// For reading only; the file must exist. Throws UserError.
    [[nodiscard]] static WorkFile existing(std::string path);
    ~WorkFile();
    WorkFile(WorkFile&& other) noexcept;
    WorkFile& operator=(WorkFile&& other) noexcept;

    /// Each throws WorkFileError where the disk fails or is full. Bytes that were never written read as 0 up to size().
    void read(std::uint64_t offset, void* destination, std::size_t count) const;
    void write(std::uint64_t offset, const void* source, std::size_t count);
    void resize(std::uint64_t bytes);
    /// What was written survives a power loss afterwards.
    void sync();

    [[nodiscard]] std::uint64_t size() const;
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    [[noreturn]] void fail(const char* what) const;

    std::string path_;
    int descriptor_ = -1;
    std::atomic<bool> changed_{false};  // since the last sync
};

}  // namespace tedavis::host_sim
