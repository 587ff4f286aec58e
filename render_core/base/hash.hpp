/// Checksums for frames and files.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tedavis::base {

/// FNV-1a, 64 bit (Fowler, Noll, Vo). Bytes may be added in any pieces; equal bytes give equal values on every machine.
class Fnv1a64 {
public:
    void add(const void* bytes, std::size_t count) noexcept;
    void add_u32_little_endian(std::uint32_t value) noexcept;
    [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// Returns the frame hash: FNV-1a over width and height, then the RGBA8 rows, top row first. `rows` holds width*height*4 bytes;
/// with `bottom_up` its first row is the bottom one, as glReadPixels returns it.
[[nodiscard]] std::uint64_t frame_hash(const std::uint8_t* rows, std::uint32_t width, std::uint32_t height,
                                       bool bottom_up) noexcept;

/// CRC-32 (ISO 3309, polynomial 0xEDB88320 reflected); detects every single flipped bit and every burst up to 32 bits.
[[nodiscard]] std::uint32_t crc32(const void* bytes, std::size_t count, std::uint32_t previous = 0) noexcept;

}  // namespace tedavis::base
