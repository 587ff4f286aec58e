/// What a source of a scene is, told by its content; its name and its role in the scene only where that leaves a choice.
#pragma once

#include <cstdint>
#include <string>

#include "render_core/scene/sdb_format.hpp"

namespace tedavis::host_sim {

enum class SourceKind : std::uint8_t {
    grid,     ///< a raster that GDAL reads
    openair,  ///< airspaces
    runways,  ///< OurAirports
    dof,      ///< the FAA's obstacles
    flight,   ///< IGC, GPX, ADS-B JSON or CSV
    vector,   ///< what is none of these; GDAL may read it as a table or map
};

/// Tables and XML with flights in them are flights to trajectories and traffic only. Throws UserError where there is no such
/// file.
[[nodiscard]] SourceKind source_kind(const std::string& path, scene::LayerRole role);

}  // namespace tedavis::host_sim
