/// A smooth random function of position: a sum of plane waves with random directions, lengths and phases. Its spatial mean is 0
/// and its variance 1; its magnitude never exceeds kMax.
#pragma once

#include <array>
#include <cstddef>

#include "host_sim/scenario/seeded_random.hpp"

namespace tedavis::host_sim {

class SeededWaves {
public:
    static constexpr std::size_t kWaves = 16;
    static constexpr double kMax = 5.66;  ///< the square root of twice the number of waves

    /// Wavelengths over the ground lie between `shortest_m` and `longest_m`. `height_m` is the height over which phases change by
    /// at most half a circle.
    SeededWaves(SeededRandom& random, double shortest_m, double longest_m, double height_m);

    [[nodiscard]] double at(double east_m, double north_m, double up_m) const;

private:
    struct Wave {
        double east_per_m = 0, north_per_m = 0, up_per_m = 0, phase_rad = 0;
    };
    std::array<Wave, kWaves> waves_;
};

}  // namespace tedavis::host_sim
