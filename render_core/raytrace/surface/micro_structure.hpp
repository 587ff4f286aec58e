/// The finer relief that is added to a surface: none, noise or a relief map (thesis 6.2.2.2).
#pragma once

#include "render_core/raytrace/surface/micro_noise.hpp"
#include "render_core/raytrace/surface/relief_map.hpp"

namespace tedavis::raytrace {

enum class MicroKind : std::uint8_t { none, noise, relief };

struct MicroStructure {
    MicroKind kind = MicroKind::none;
    MicroNoise noise;
    ReliefMap relief;
};

/// Returns the added height and slopes at a point of grid space.
[[nodiscard]] inline SurfacePoint micro_structure_at(const MicroStructure& micro, double x, double y) {
    switch (micro.kind) {
        case MicroKind::noise: return noise_at(micro.noise, x, y);
        case MicroKind::relief: return relief_at(micro.relief, x, y);
        case MicroKind::none: break;
    }
    return {};
}

/// Upper bound of the added height's magnitude, in height steps.
[[nodiscard]] inline double amplitude_of(const MicroStructure& micro) {
    switch (micro.kind) {
        case MicroKind::noise: return micro.noise.amplitude;
        case MicroKind::relief: return micro.relief.amplitude;
        case MicroKind::none: break;
    }
    return 0;
}

/// Upper bound of its slopes along x or y.
[[nodiscard]] inline double steepest_slope(const MicroStructure& micro) {
    switch (micro.kind) {
        case MicroKind::noise: return steepest_slope(micro.noise);
        case MicroKind::relief: return steepest_slope(micro.relief);
        case MicroKind::none: break;
    }
    return 0;
}

}  // namespace tedavis::raytrace
