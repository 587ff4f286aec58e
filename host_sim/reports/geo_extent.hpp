/// The region on Earth that a terrain, a scene or a flight covers, for messages about inputs that do not match.
#pragma once

#include <string>

#include "render_core/scene/scene.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// Degrees. A region across the antimeridian spans from its least to its greatest longitude, so it is too large rather than too
/// small.
struct GeoExtent {
    double south_deg = 90, north_deg = -90, west_deg = 180, east_deg = -180;

    void include(double latitude_deg, double longitude_deg);
    [[nodiscard]] bool is_empty() const { return south_deg > north_deg; }
    /// "46.500 .. 47.100 N, 9.600 .. 10.200 E".
    [[nodiscard]] std::string words() const;
};

[[nodiscard]] GeoExtent extent_of(const terrain::TerrainDatabase& database);
[[nodiscard]] GeoExtent extent_of(const scene::Scene& scene);

/// True if neither extent is empty and the gap between them is more than `degrees`.
[[nodiscard]] bool are_apart(const GeoExtent& a, const GeoExtent& b, double degrees);

}  // namespace tedavis::host_sim
