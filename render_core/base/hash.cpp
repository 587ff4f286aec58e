#include "render_core/base/hash.hpp"

#include <array>

namespace tedavis::base {
namespace {

constexpr std::size_t kSlices = 8;
using CrcTables = std::array<std::array<std::uint32_t, 256>, kSlices>;

/// Table k: the remainder of a byte that k zero bytes follow.
constexpr CrcTables make_crc_tables() {
    CrcTables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1u) != 0 ? 0xEDB88320u : 0u);
        tables[0][byte] = remainder;
    }
    for (std::size_t k = 1; k < kSlices; ++k)
        for (std::size_t byte = 0; byte < 256; ++byte)
            tables[k][byte] = (tables[k - 1][byte] >> 8) ^ tables[0][tables[k - 1][byte] & 0xFFu];
    return tables;
}
constexpr CrcTables kCrc = make_crc_tables();

/// Slicing by 8: Kounavis and Berry, A systematic approach to building high performance software-based CRC generators (ISCC
/// 2005).
std::uint32_t crc_of_eight(std::uint32_t crc, const unsigned char* p) {
    const auto first = [crc, p](unsigned n) { return ((crc >> (8 * n)) ^ p[n]) & 0xFFu; };
    return kCrc[7][first(0)] ^ kCrc[6][first(1)] ^ kCrc[5][first(2)] ^ kCrc[4][first(3)] ^ kCrc[3][p[4]] ^ kCrc[2][p[5]] ^
           kCrc[1][p[6]] ^ kCrc[0][p[7]];
}

}  // namespace

void Fnv1a64::add(const void* bytes, std::size_t count) noexcept {
    const auto* p = static_cast<const unsigned char*>(bytes);
    std::uint64_t h = value_;
    for (std::size_t i = 0; i < count; ++i) h = (h ^ p[i]) * 0x100000001b3u;
    value_ = h;
}

void Fnv1a64::add_u32_little_endian(std::uint32_t value) noexcept {
    const unsigned char bytes[4] = {static_cast<unsigned char>(value), static_cast<unsigned char>(value >> 8),
                                    static_cast<unsigned char>(value >> 16), static_cast<unsigned char>(value >> 24)};
    add(bytes, 4);
}

std::uint64_t frame_hash(const std::uint8_t* rows, std::uint32_t width, std::uint32_t height, bool bottom_up) noexcept {
    Fnv1a64 hash;
    hash.add_u32_little_endian(width);
    hash.add_u32_little_endian(height);
    const std::size_t stride = std::size_t{width} * 4;
    for (std::uint32_t y = 0; y < height; ++y) hash.add(rows + stride * (bottom_up ? height - 1 - y : y), stride);
    return hash.value();
}

std::uint32_t crc32(const void* bytes, std::size_t count, std::uint32_t previous) noexcept {
    const auto* p = static_cast<const unsigned char*>(bytes);
    std::uint32_t crc = ~previous;
    for (; count >= kSlices; count -= kSlices, p += kSlices) crc = crc_of_eight(crc, p);
    for (; count > 0; --count, ++p) crc = (crc >> 8) ^ kCrc[0][(crc ^ *p) & 0xFFu];
    return ~crc;
}

}  // namespace tedavis::base
