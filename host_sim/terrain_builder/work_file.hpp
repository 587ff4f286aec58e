/// A file for intermediate and final results, with reads and writes at offsets, from any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

/// The disk failed or is full; once this is repaired, the same build can be continued.
class WorkFileError : public UserError {
public:
    using UserError::UserError;
};

class WorkFile {
public:
    WorkFile() = default;
    /// Opens the file for reading and writing; makes it where it does not exist. Throws UserError.
    explicit WorkFile(std::string path);
    /// Opens an existing file for reading only. Throws UserError.
    [[nodiscard]] static WorkFile existing(std::string path);
    ~WorkFile();
    WorkFile(WorkFile&& other) noexcept;
    WorkFile& operator=(WorkFile&& other) noexcept;

    /// Each throws WorkFileError where the disk fails or is full. Bytes that were never written read as 0 up to size().
    void read(std::uint64_t offset, void* destination, std::size_t count) const;
    void write(std::uint64_t offset, const void* source, std::size_t count);
    void resize(std::uint64_t bytes);
    /// Writes all changes to the disk, so that they survive a power failure.
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
