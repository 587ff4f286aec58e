#include "render_core/raytrace/picture/display_levels.hpp"

#include <cmath>

namespace tedavis::raytrace {
namespace {

/// x^(1 / 2.4) of 0..1, as x^(5 / 12), by square roots and Newton's cube root: no function of the C library that differs between
/// machines.
double display_power(double x) {
    const double fourth = std::sqrt(std::sqrt(x));
    double root = 0.5 + 0.5 * fourth;
    for (int n = 0; n < 8; ++n) root -= (root - fourth / (root * root)) / 3;
    const double square = root * root;
    return square * square * root;
}

}  // namespace

bool DisplayLevels::start(base::Arena& arena) {
    levels_ = arena.allocate_array<std::uint8_t>(kEntries);
    for (std::uint32_t n = 0; n < levels_.size(); ++n) {
        const double light = n / (kEntries - 1.0);
        const double shown = light <= 0.0031308 ? 12.92 * light : 1.055 * display_power(light) - 0.055;
        levels_[n] = static_cast<std::uint8_t>(255 * shown + 0.5);
    }
    return !levels_.empty();
}

}  // namespace tedavis::raytrace
