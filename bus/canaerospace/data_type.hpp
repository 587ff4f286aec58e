/// The data types of CANaerospace 1.7 (section 2.2): big-endian payloads of zero to four bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tedavis::bus {

enum class DataType : std::uint8_t {
    nodata = 0,
    error,
    float32,
    long32,
    ulong32,
    blong32,
    short16,
    ushort16,
    bshort16,
    char8,
    uchar8,
    bchar8,
    short16x2,
    ushort16x2,
    bshort16x2,
    char8x4,
    uchar8x4,
    bchar8x4,
    char8x2,
    uchar8x2,
    bchar8x2,
    memid,
    checksum,
    achar8,
    achar8x2,
    achar8x4,
    char8x3,
    uchar8x3,
    bchar8x3,
    achar8x3,
    double_high,
    double_low,
};
inline constexpr std::uint8_t kDataTypeCount = 32;  ///< 32..99 are reserved, 100..255 user-defined

/// A payload with its type. FLOAT is in `real`, everything else in `parts`: SHORT2 has two, UCHAR4 four, ERROR three
/// (location, operation, code); DOUBLEH and DOUBLEL hold one half of the IEEE-754 bits each.
struct TypedValue {
    DataType type = DataType::nodata;
    std::uint8_t count = 0;
    float real = 0;
    std::array<std::int64_t, 4> parts{};
};
static_assert(std::is_trivially_copyable_v<TypedValue>);

struct TypeLayout {
    std::uint8_t bytes = 0;  ///< of the whole payload
    std::uint8_t count = 0;  ///< elements
    bool is_signed = false;
    bool known = false;
};
/// Returns the layout of a type; `known` is false for reserved and user-defined codes.
[[nodiscard]] TypeLayout type_layout(std::uint8_t code) noexcept;

/// Returns false when the code is unknown or `available` is less than the type needs; extra bytes are ignored.
[[nodiscard]] bool decode_value(std::uint8_t code, const std::uint8_t* bytes, std::size_t available, TypedValue& out) noexcept;
/// Writes the payload and returns its length; each part must lie in its element's range (higher bits are cut off).
std::size_t encode_value(const TypedValue& value, std::uint8_t* out) noexcept;

/// Returns the number that an analogue value stands for: a FLOAT's value, first * second / 32767 for SHORT2 (section 5), the
/// first element of integer types, NaN for types that are not numbers.
[[nodiscard]] double number_of(const TypedValue& value) noexcept;
/// Encodes a value as SHORT2 with a full scale of 1..32767 in the value's unit; values beyond the scale saturate.
[[nodiscard]] TypedValue short2_of(double value, std::int16_t full_scale) noexcept;

[[nodiscard]] double double_from_halves(std::uint32_t high, std::uint32_t low) noexcept;
void split_double(double value, std::uint32_t& high, std::uint32_t& low) noexcept;

}  // namespace tedavis::bus
