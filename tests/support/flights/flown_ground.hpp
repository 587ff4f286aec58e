/// What a budget flight goes over: a square of ground, and how low it is flown.
#pragma once

#include <functional>
#include <memory>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/terrain_builder/fractal_geotiff.hpp"
#include "host_sim/terrain_builder/fractal_terrain.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::test_support {

/// The database must hold all of it.
struct FlownGround {
    double north_deg = 0, west_deg = 0;
    double side_s = 0;  ///< seconds of arc
    /// Metres above the ellipsoid, of a latitude and a longitude in degrees.
    std::function<double(double, double)> ellipsoid_m;
    double looking_down_m = 1800, looking_ahead_m = 900;  ///< of the eye above it
};

/// The north-western `side` posts a side of FractalPosts' terrain.
[[nodiscard]] inline FlownGround fractal_ground(std::uint32_t side) {
    struct Fractal {
        host_sim::FractalTerrain terrain{1};
        host_sim::GeoidEgm96 geoid = host_sim::GeoidEgm96::installed();
    };
    FlownGround ground;
    ground.north_deg = host_sim::kFractalNorth_deg;
    ground.west_deg = host_sim::kFractalWest_deg;
    ground.side_s = 3600 * host_sim::kFractalStep_deg * side;
    ground.ellipsoid_m = [fractal = std::make_shared<Fractal>()](double latitude_deg, double longitude_deg) {
        float ground_m = 0;
        fractal->terrain.read(
            static_cast<std::int32_t>((longitude_deg - host_sim::kFractalWest_deg) / host_sim::kFractalStep_deg),
            static_cast<std::int32_t>((host_sim::kFractalNorth_deg - latitude_deg) / host_sim::kFractalStep_deg), 1, 1,
            {&ground_m, 1});
        return double{ground_m} + fractal->geoid.undulation(base::radians(latitude_deg), base::radians(longitude_deg)).m;
    };
    return ground;
}

}  // namespace tedavis::test_support
