#include "render_core/scene/uncertainty.hpp"

#include <cmath>

namespace tedavis::scene {
namespace {

constexpr double kHour_s = 3600;
constexpr double kRounding = 1e-9;  // of a level that was a code before

}  // namespace

// Comparisons are written so that NaN fails them: a cast of NaN is 0, certain, on some machines.
Uncertainty Uncertainty::from_level(double level) noexcept {
    if (!(level >= 0)) return {};
    if (!(level < 1)) return Uncertainty(kFull);
    return Uncertainty(static_cast<std::uint8_t>(std::ceil(level * kFull - kRounding)));
}

Uncertainty aged(Uncertainty uncertainty, base::Duration age, double growth_per_hour) noexcept {
    if (!uncertainty.is_known() || !(growth_per_hour >= 0)) return {};
    return Uncertainty::from_level(uncertainty.level() + growth_per_hour * std::abs(age.to_seconds()) / kHour_s);
}

Uncertainty worse(Uncertainty a, Uncertainty b) noexcept { return a.code() > b.code() ? a : b; }

}  // namespace tedavis::scene
