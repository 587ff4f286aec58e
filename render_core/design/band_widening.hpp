/// By how much the limits of the warning bands go down, because neither the own ship's height nor the terrain's is known exactly.
///
/// The shown height of terrain over the aircraft errs by sigma = sqrt(position^2 + terrain^2). A limit that is k sigma lower
/// colours at least the share `coverage` of the terrain that truly reaches the band (one-sided normal quantile k): more terrain
/// is coloured than must be, never less. Conventions: a vertical figure of merit holds 95 % of the errors to either side (1.960
/// sigma), LE90 holds 90 % (1.645 sigma). Pure functions; any thread.
#pragma once

#include <type_traits>

namespace tedavis::design {

struct WideningSettings {
    bool enabled = true;
    double coverage = 0.95;           ///< (0.5 .. 0.9999) of terrain in a band that has its colour
    double position_accuracy_m = 20;  ///< vertical figure of merit where the aircraft states none, (0 .. 1000)
    double terrain_accuracy_m = 30;   ///< LE90 where the database states none, (0 .. 1000)
};

/// What is known of a frame; 0 or less, or NaN: not stated.
struct HeightAccuracy {
    double position_m = 0;  ///< vertical figure of merit, 95 %
    double terrain_m = 0;   ///< LE90 of the database
};

struct BandWidening {
    double lowered_m = 0;  ///< every limit lies so much lower; 0: not widened
    double position_sigma_m = 0;
    double terrain_sigma_m = 0;
    bool position_assumed = false;  ///< by the design, for nobody states it
    bool terrain_assumed = false;
};
static_assert(std::is_trivially_copyable_v<BandWidening>);

/// Standard deviations below which the share `coverage` of a normal distribution lies; `coverage` in (0.5 .. 0.9999).
[[nodiscard]] double deviations_of_coverage(double coverage) noexcept;

/// `deviations` is deviations_of_coverage(settings.coverage), which the caller keeps as long as its settings.
[[nodiscard]] BandWidening band_widening(const WideningSettings& settings, double deviations,
                                         const HeightAccuracy& accuracy) noexcept;

}  // namespace tedavis::design
