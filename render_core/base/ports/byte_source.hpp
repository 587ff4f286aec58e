/// Port: bytes at an offset, from which the core reads a database. Implemented in platform/files, and in memory by tests.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tedavis::base {

class ByteSource {
public:
    virtual ~ByteSource() = default;
    [[nodiscard]] virtual std::uint64_t size() const = 0;
    /// Reads exactly `count` bytes at `offset`; returns false when some are missing or the medium fails; `destination` is then
    /// unspecified. Thread-safe; never allocates.
    [[nodiscard]] virtual bool read(std::uint64_t offset, void* destination, std::size_t count) = 0;
};

}  // namespace tedavis::base
