#include "render_core/raytrace/picture/display_levels.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/raytrace/picture/wide_loops.hpp"

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

/// What is no number is black.
TEDAVIS_WIDE_LOOPS void find_entries(const float* light, std::uint32_t count, std::int32_t* entries) {
    constexpr float kHalf = 0.5f;
    for (std::uint32_t n = 0; n < count; ++n) {
        const float above = light[n] > 0 ? light[n] : 0;
        entries[n] = static_cast<std::int32_t>((above < 1 ? above : 1) * (DisplayLevels::kEntries - 1) + kHalf);
    }
}

}  // namespace

bool DisplayLevels::start(base::Arena& arena) {
    levels_ = arena.allocate_array<std::uint8_t>(kEntries);
    for (std::uint32_t n = 0; n < levels_.size(); ++n) {
        const double light = n / (kEntries - 1.0);
        const double shown = light <= 0.0031308 ? 12.92 * light : 1.055 * display_power(light) - 0.055;
        levels_[n] = static_cast<std::uint8_t>(std::floor(255 * shown + 0.5));
    }
    return !levels_.empty();
}

void DisplayLevels::set(const float* light, std::uint32_t count, std::uint8_t* levels) const {
    constexpr std::uint32_t kTogether = 192;
    std::int32_t entry[kTogether];
    const std::uint8_t* const table = levels_.data();
    for (std::uint32_t first = 0; first < count; first += kTogether) {
        const std::uint32_t end = std::min(kTogether, count - first);
        find_entries(light + first, end, entry);
        for (std::uint32_t n = 0; n < end; ++n) levels[first + n] = table[entry[n]];
    }
}

}  // namespace tedavis::raytrace
