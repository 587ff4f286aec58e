/// The aircraft's signals at one instant, as a flight source knows them.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "render_core/flight/signal.hpp"

namespace tedavis::host_sim {

/// SI and radians by signal; an absent value is NaN.
struct SignalSample {
    std::array<double, flight::kSignalCount> values;

    SignalSample() { values.fill(std::numeric_limits<double>::quiet_NaN()); }
    [[nodiscard]] double& operator[](flight::Signal signal) { return values[static_cast<std::size_t>(signal)]; }
    [[nodiscard]] double operator[](flight::Signal signal) const { return values[static_cast<std::size_t>(signal)]; }
    [[nodiscard]] bool has(flight::Signal signal) const { return !std::isnan((*this)[signal]); }
};

}  // namespace tedavis::host_sim
