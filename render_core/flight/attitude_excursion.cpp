#include "render_core/flight/attitude_excursion.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::flight {
namespace {

double after_play(double before_rad, double angle_rad) {
    if (std::isnan(angle_rad)) return 0;
    return std::clamp(before_rad, angle_rad, angle_rad + AttitudeExcursion::kPlay_rad);
}

}  // namespace

void AttitudeExcursion::step(double pitch_rad, double roll_rad) noexcept {
    pitch_up_rad = after_play(pitch_up_rad, pitch_rad);
    pitch_down_rad = after_play(pitch_down_rad, -pitch_rad);
    bank_rad = after_play(bank_rad, std::fabs(roll_rad));
}

}  // namespace tedavis::flight
