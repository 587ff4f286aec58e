#include "render_core/earth/geodetic.hpp"

#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::earth {

using base::kPi;

double wrap_longitude(double longitude_rad) noexcept {
    const double wrapped = std::remainder(longitude_rad, 2 * kPi);
    return wrapped >= kPi ? -kPi : wrapped;
}

double wrap_heading(double angle_rad) noexcept {
    const double wrapped = std::remainder(angle_rad, 2 * kPi);
    const double positive = wrapped < 0 ? wrapped + 2 * kPi : wrapped;
    return positive >= 2 * kPi ? 0.0 : positive + 0.0;  // turns -0 into 0
}

double angle_difference(double a_rad, double b_rad) noexcept { return std::remainder(a_rad - b_rad, 2 * kPi); }

}  // namespace tedavis::earth
