#include "render_core/design/band_widening.hpp"

#include <cmath>

namespace tedavis::design {
namespace {

constexpr double kSigmasOfFigureOfMerit = 1.959964;  // 95 % to either side
constexpr double kSigmasOfLe90 = 1.644854;           // 90 % to either side

}  // namespace

double deviations_of_coverage(double coverage) noexcept {
    double low = 0, high = 4;
    for (int step = 0; step < 50; ++step) {
        const double middle = 0.5 * (low + high);
        const bool covers = 1 - 0.5 * std::erfc(middle / std::sqrt(2.0)) >= coverage;
        (covers ? high : low) = middle;
    }
    return high;
}

BandWidening band_widening(const WideningSettings& settings, double deviations, const HeightAccuracy& accuracy) noexcept {
    BandWidening widening;
    if (!settings.enabled) return widening;
    widening.position_assumed = !(accuracy.position_m > 0);
    widening.terrain_assumed = !(accuracy.terrain_m > 0);
    widening.position_sigma_m =
        (widening.position_assumed ? settings.position_accuracy_m : accuracy.position_m) / kSigmasOfFigureOfMerit;
    widening.terrain_sigma_m = (widening.terrain_assumed ? settings.terrain_accuracy_m : accuracy.terrain_m) / kSigmasOfLe90;
    widening.lowered_m = deviations * std::hypot(widening.position_sigma_m, widening.terrain_sigma_m);
    return widening;
}

}  // namespace tedavis::design
