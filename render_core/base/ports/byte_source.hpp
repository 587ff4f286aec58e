/// What the core needs to read a database: bytes at an offset. Implemented by platform/files and by tests in memory.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tedavis::base {

class ByteSource {
public:
    virtual ~ByteSource() = default;
    [[nodiscard]] virtual std::uint64_t size() const = 0;
    /// Reads exactly `count` bytes at `offset`; false when they are not all there or the medium fails, and then
    /// `destination` is unspecified. Thread-safe; never allocates.
    [[nodiscard]] virtual bool read(std::uint64_t offset, void* destination, std::size_t count) = 0;
};

}  // namespace tedavis::base
