/// Checks whether a scene has data near a flight and for its time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Returns the extent of the data of a scene database; empty without a path. Throws UserError where it cannot be read.
[[nodiscard]] GeoExtent extent_of_scene(const std::string& path);

/// Returns a finding if all data lie far from the flight. `scene` is the path of a scene database with this extent, or empty;
/// `flown` is the extent of the own ship's positions.
[[nodiscard]] Findings scene_findings(const std::string& scene, const GeoExtent& extent, const GeoExtent& flown);

/// The times of a layer's data, UTC.
struct LayerTimes {
    std::string layer;
    std::int64_t first_ns = 0, last_ns = 0;  ///< times of the data themselves
    std::int64_t from_ns = 0, until_ns = 0;  ///< times of flights for which they are valid
};

/// Returns the times of the layers of weather and traffic that state any. They are taken as valid from an hour before the first
/// data until the end of validity that the layer states, else a day after the last data. Empty without a path. Throws UserError
/// where the scene cannot be read.
[[nodiscard]] std::vector<LayerTimes> times_of_scene(const std::string& path);

/// Returns a finding for each layer that is valid at no time of the flight from `begin` to `end`, UTC.
[[nodiscard]] Findings time_findings(const std::string& scene, const std::vector<LayerTimes>& layers, base::Time begin,
                                     base::Time end);

}  // namespace tedavis::host_sim
