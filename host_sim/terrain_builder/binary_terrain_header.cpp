#include "host_sim/terrain_builder/binary_terrain_header.hpp"

#include <cpl_port.h>
#include <cpl_vsi.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kExternalProjectionAt = 60, kVerticalScaleAt = 62, kRead = 66;

float little_endian_float(const unsigned char* bytes) {
    const std::uint32_t bits =
        std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

}  // namespace

std::optional<BinaryTerrainHeader> read_binary_terrain_header(const std::string& file) {
    unsigned char bytes[kRead];
    VSILFILE* const stream = VSIFOpenL(file.c_str(), "rb");
    if (stream == nullptr) return std::nullopt;
    const bool read = VSIFReadL(bytes, 1, kRead, stream) == kRead;
    VSIFCloseL(stream);
    if (!read || std::memcmp(bytes, "binterr1.", 9) != 0) return std::nullopt;
    BinaryTerrainHeader header;
    if (bytes[9] == '0') return header;  // version 1.0 knows neither field; later ones leave zeros where they say nothing
    const float scale = little_endian_float(bytes + kVerticalScaleAt);
    if (std::isfinite(scale) && scale > 0) header.metres_per_unit = static_cast<double>(scale);
    header.projection_file_needed = bytes[kExternalProjectionAt] == 1;
    return header;
}

}  // namespace tedavis::host_sim
