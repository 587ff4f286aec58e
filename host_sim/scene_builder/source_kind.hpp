/// The kind of a source of a scene, detected by its content, and by its name and its role in the scene only where the content is
/// ambiguous.
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
    vector,   ///< none of these; GDAL may read it as a table or map
};

/// Tables and XML with flights are flights only for the roles trajectories and traffic. Throws UserError where there is no such
/// file.
[[nodiscard]] SourceKind source_kind(const std::string& path, scene::LayerRole role);

}  // namespace tedavis::host_sim
