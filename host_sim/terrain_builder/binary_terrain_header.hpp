/// Fields of a VTP binary terrain file (.bt 1.0 to 1.3) that GDAL does not return. Format: Virtual Terrain Project, "BT (Binary
/// Terrain) File Format": a header of 256 bytes, little-endian.
#pragma once

#include <optional>
#include <string>

namespace tedavis::host_sim {

struct BinaryTerrainHeader {
    double metres_per_unit = 1;           ///< of the heights
    bool projection_file_needed = false;  ///< its coordinate system is in a .prj file beside it
};

/// Empty where the file cannot be read or is no binary terrain.
[[nodiscard]] std::optional<BinaryTerrainHeader> read_binary_terrain_header(const std::string& file);

}  // namespace tedavis::host_sim
