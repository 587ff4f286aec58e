/// Whether a scene can have anything to do with a flight: whether it is of its place and of its time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Of the data of a scene database; empty without a path. Throws UserError where it cannot be read.
[[nodiscard]] GeoExtent extent_of_scene(const std::string& path);

/// `scene`: path of a scene database with this extent, or empty; `flown`: where the own ship was.
[[nodiscard]] Findings scene_findings(const std::string& scene, const GeoExtent& extent, const GeoExtent& flown);

/// When the data of a layer hold.
struct LayerTimes {
    std::string layer;
    std::int64_t first_ns = 0, last_ns = 0;  ///< of the data themselves
    std::int64_t from_ns = 0, until_ns = 0;  ///< the flights that they are for
};

/// Of the layers of weather and of traffic that state a time: of the data an hour before and, where no validity is stated, a day
/// after. Empty without a path. Throws UserError where it cannot be read.
[[nodiscard]] std::vector<LayerTimes> times_of_scene(const std::string& path);

/// One for each layer of the scene that is of another time than all of the flight, which is from `begin` to `end`, UTC.
[[nodiscard]] Findings time_findings(const std::string& scene, const std::vector<LayerTimes>& layers, base::Time begin,
                                     base::Time end);

}  // namespace tedavis::host_sim
