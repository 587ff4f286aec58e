/// Lowers the limits of the warning bands for the uncertainty of the own ship's height and of the terrain's.
///
/// The height of terrain relative to the aircraft has the standard deviation sigma = sqrt(position^2 + terrain^2). With a limit
/// lowered by k sigma, at least the share `coverage` of the terrain that truly reaches the band has its colour (one-sided
/// normal quantile k). Conventions: a vertical figure of merit bounds 95 % of the errors, two-sided (1.960 sigma), LE90 bounds
/// 90 % (1.645 sigma). Pure functions; any thread.
#pragma once

#include <type_traits>

namespace tedavis::design {

struct WideningSettings {
    bool enabled = true;
    double coverage = 0.95;           ///< (0.5 .. 0.9999) share of the terrain in a band that gets its colour
    double position_accuracy_m = 20;  ///< vertical figure of merit where the aircraft states none, (0 .. 1000)
    double terrain_accuracy_m = 30;   ///< LE90 where the database states none, (0 .. 1000)
};

/// The stated accuracies in a frame; 0 or less, or NaN: not stated.
struct HeightAccuracy {
    double position_m = 0;  ///< vertical figure of merit, 95 %
    double terrain_m = 0;   ///< LE90 of the database
};

struct BandWidening {
    double lowered_m = 0;  ///< amount by which every limit is lowered; 0: not widened
    double position_sigma_m = 0;
    double terrain_sigma_m = 0;
    bool position_assumed = false;  ///< no accuracy was stated: the design's value was used
    bool terrain_assumed = false;
};
static_assert(std::is_trivially_copyable_v<BandWidening>);

/// Returns the quantile of the standard normal distribution for `coverage` in (0.5 .. 0.9999).
[[nodiscard]] double deviations_of_coverage(double coverage) noexcept;

/// `deviations` is deviations_of_coverage(settings.coverage), which the caller computes once for its settings.
[[nodiscard]] BandWidening band_widening(const WideningSettings& settings, double deviations,
                                         const HeightAccuracy& accuracy) noexcept;

}  // namespace tedavis::design
