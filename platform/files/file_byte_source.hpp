/// A file as a ByteSource: positioned reads, no cache of its own.
///
/// Thread  reads from any thread at once. Memory  none after opening. Lifetime  the file is open as long as the object.
#pragma once

#include <cstdint>

#include "render_core/base/error.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

class FileByteSource final : public base::ByteSource {
public:
    FileByteSource() = default;
    ~FileByteSource() override;
    FileByteSource(FileByteSource&& other) noexcept;
    FileByteSource& operator=(FileByteSource&& other) noexcept;

    /// The file's size when it was opened; reads fail where the file has shrunk since.
    [[nodiscard]] std::uint64_t size() const override { return size_; }
    [[nodiscard]] bool read(std::uint64_t offset, void* destination, std::size_t count) override;

private:
    friend base::Result<FileByteSource, base::Error> open_file(const char*);
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

/// Opens a regular file. The error names the file and the reason.
[[nodiscard]] base::Result<FileByteSource, base::Error> open_file(const char* path);

}  // namespace tedavis::platform
