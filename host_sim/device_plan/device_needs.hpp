/// The requirements of a design, a terrain database and a scene on a device, independent of its memory.
///
/// Thread  any. Failure  throws UserError, one sentence with the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host_sim/options/picture_options.hpp"
#include "render_core/design/terrain_style.hpp"

namespace tedavis::host_sim {

struct TerrainNeeds {
    std::uint64_t table_bytes = 0;   ///< of the page table and the undulation grid
    std::uint32_t pages = 0;         ///< of the directory
    std::uint32_t roots = 0;         ///< chunks that are always resident
    std::uint64_t traced_bytes = 0;  ///< of its posts and chunks, where it is traced
};

struct DeviceNeeds {
    std::string design;     ///< as the user named it
    design::MapSet maps;    ///< of all phases' designs
    bool has_coast = true;  ///< true: the light map is needed as well; also true where the terrain is not known
    bool has_drape = false, has_shadows = false, is_traced = false, measures_clutter = false;
    bool shades_traced = false;  ///< a style of traced terrain is shaded from a geometry picture
    std::optional<TerrainNeeds> terrain;
    std::optional<std::uint64_t> scene_file_bytes;
};

/// Returns the needs of the options' design, terrain and scene; the latter two may be empty.
[[nodiscard]] DeviceNeeds device_needs(const PictureOptions& options);

}  // namespace tedavis::host_sim
