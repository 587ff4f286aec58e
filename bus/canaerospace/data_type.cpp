#include "bus/canaerospace/data_type.hpp"

#include <cmath>
#include <cstring>
#include <limits>

namespace tedavis::bus {
namespace {

constexpr double kShort2Scale = 32767.0;

constexpr TypeLayout kLayouts[kDataTypeCount] = {
    {0, 0, false, true},  // NODATA
    {4, 3, true, true},   // ERROR
    {4, 1, false, true},  // FLOAT
    {4, 1, true, true},   // LONG
    {4, 1, false, true},  // ULONG
    {4, 1, false, true},  // BLONG
    {2, 1, true, true},   // SHORT
    {2, 1, false, true},  // USHORT
    {2, 1, false, true},  // BSHORT
    {1, 1, true, true},   // CHAR
    {1, 1, false, true},  // UCHAR
    {1, 1, false, true},  // BCHAR
    {4, 2, true, true},   // SHORT2
    {4, 2, false, true},  // USHORT2
    {4, 2, false, true},  // BSHORT2
    {4, 4, true, true},   // CHAR4
    {4, 4, false, true},  // UCHAR4
    {4, 4, false, true},  // BCHAR4
    {2, 2, true, true},   // CHAR2
    {2, 2, false, true},  // UCHAR2
    {2, 2, false, true},  // BCHAR2
    {4, 1, false, true},  // MEMID
    {4, 1, false, true},  // CHKSUM
    {1, 1, false, true},  // ACHAR
    {2, 2, false, true},  // ACHAR2
    {4, 4, false, true},  // ACHAR4
    {3, 3, true, true},   // CHAR3
    {3, 3, false, true},  // UCHAR3
    {3, 3, false, true},  // BCHAR3
    {3, 3, false, true},  // ACHAR3
    {4, 1, false, true},  // DOUBLEH
    {4, 1, false, true},  // DOUBLEL
};

/// ERROR is the one type whose elements differ in size: two bytes and a 16-bit code.
std::size_t element_bytes(DataType type, const TypeLayout& layout, std::size_t index) {
    if (type == DataType::error) return index < 2 ? 1 : 2;
    return layout.bytes / layout.count;
}

std::int64_t big_endian(const std::uint8_t* bytes, std::size_t count, bool is_signed) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < count; ++i) bits = bits << 8 | bytes[i];
    const auto value = static_cast<std::int64_t>(bits);
    const std::int64_t sign = std::int64_t{1} << (8 * count - 1);
    return is_signed && (value & sign) != 0 ? value - 2 * sign : value;
}

void put_big_endian(std::int64_t value, std::size_t count, std::uint8_t* out) {
    auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = count; i-- > 0; bits >>= 8) out[i] = static_cast<std::uint8_t>(bits);
}

}  // namespace

TypeLayout type_layout(std::uint8_t code) noexcept { return code < kDataTypeCount ? kLayouts[code] : TypeLayout(); }

bool decode_value(std::uint8_t code, const std::uint8_t* bytes, std::size_t available, TypedValue& out) noexcept {
    const TypeLayout layout = type_layout(code);
    if (!layout.known || available < layout.bytes) return false;
    out = TypedValue();
    out.type = static_cast<DataType>(code);
    out.count = layout.count;
    std::size_t at = 0;
    for (std::size_t i = 0; i < layout.count; ++i) {
        const std::size_t size = element_bytes(out.type, layout, i);
        out.parts[i] = big_endian(bytes + at, size, layout.is_signed);
        at += size;
    }
    if (out.type == DataType::float32) {
        const auto bits = static_cast<std::uint32_t>(out.parts[0]);
        std::memcpy(&out.real, &bits, sizeof bits);
        out.parts[0] = 0;
    }
    return true;
}

std::size_t encode_value(const TypedValue& value, std::uint8_t* out) noexcept {
    const TypeLayout layout = type_layout(static_cast<std::uint8_t>(value.type));
    if (value.type == DataType::float32) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value.real, sizeof bits);
        put_big_endian(bits, 4, out);
        return 4;
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < layout.count; ++i) {
        const std::size_t size = element_bytes(value.type, layout, i);
        put_big_endian(value.parts[i], size, out + at);
        at += size;
    }
    return layout.bytes;
}

double number_of(const TypedValue& value) noexcept {
    switch (value.type) {
        case DataType::float32: return static_cast<double>(value.real);
        case DataType::short16x2: return static_cast<double>(value.parts[0]) * static_cast<double>(value.parts[1]) / kShort2Scale;
        case DataType::long32:
        case DataType::ulong32:
        case DataType::blong32:
        case DataType::short16:
        case DataType::ushort16:
        case DataType::bshort16:
        case DataType::char8:
        case DataType::uchar8:
        case DataType::bchar8: return static_cast<double>(value.parts[0]);
        default: return std::numeric_limits<double>::quiet_NaN();
    }
}

TypedValue short2_of(double value, std::int16_t full_scale) noexcept {
    TypedValue result;
    result.type = DataType::short16x2;
    result.count = 2;
    const double scaled = value / static_cast<double>(full_scale) * kShort2Scale;
    const double limited = scaled > kShort2Scale ? kShort2Scale : scaled < -kShort2Scale ? -kShort2Scale : scaled;
    result.parts[0] = std::isnan(limited) ? 0 : std::llround(limited);
    result.parts[1] = full_scale;
    return result;
}

double double_from_halves(std::uint32_t high, std::uint32_t low) noexcept {
    const std::uint64_t bits = static_cast<std::uint64_t>(high) << 32 | low;
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

void split_double(double value, std::uint32_t& high, std::uint32_t& low) noexcept {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    high = static_cast<std::uint32_t>(bits >> 32);
    low = static_cast<std::uint32_t>(bits);
}

}  // namespace tedavis::bus
