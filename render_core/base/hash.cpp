#include "render_core/base/hash.hpp"

#include <array>

namespace tedavis::base {
namespace {

constexpr std::array<std::uint32_t, 256> make_crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1u) != 0 ? 0xEDB88320u : 0u);
        table[byte] = remainder;
    }
    return table;
}
constexpr std::array<std::uint32_t, 256> kCrcTable = make_crc_table();

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
    for (std::size_t i = 0; i < count; ++i) crc = (crc >> 8) ^ kCrcTable[(crc ^ p[i]) & 0xFFu];
    return ~crc;
}

}  // namespace tedavis::base
