#include "host_sim/scenario/seeded_waves.hpp"

#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

SeededWaves::SeededWaves(SeededRandom& random, double shortest_m, double longest_m, double height_m) {
    for (Wave& wave : waves_) {
        const double bearing_rad = 2 * base::kPi * random.unit();
        const double length_m = shortest_m + (longest_m - shortest_m) * random.unit();
        wave.east_per_m = 2 * base::kPi / length_m * std::sin(bearing_rad);
        wave.north_per_m = 2 * base::kPi / length_m * std::cos(bearing_rad);
        wave.up_per_m = random.within(0, base::kPi / height_m);
        wave.phase_rad = 2 * base::kPi * random.unit();
    }
}

double SeededWaves::at(double east_m, double north_m, double up_m) const {
    double sum = 0;
    for (const Wave& wave : waves_)
        sum += std::sin(wave.east_per_m * east_m + wave.north_per_m * north_m + wave.up_per_m * up_m + wave.phase_rad);
    return std::sqrt(2.0 / kWaves) * sum;
}

}  // namespace tedavis::host_sim
