/// A map of the terrain as a picture: tints by height under a light from the north-west, north up.
///
/// Latitude and longitude are linear in rows and columns. Sea is blue; places without a height are grey.
#pragma once

#include "host_sim/png_file.hpp"
#include "host_sim/reports/geo_extent.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// `width` and `height` are at least 2 pixels. The picture is grey where the extent lies outside the database.
[[nodiscard]] RgbaPicture shaded_relief(const terrain::TerrainDatabase& database, const GeoExtent& extent, std::uint32_t width,
                                        std::uint32_t height);

}  // namespace tedavis::host_sim
