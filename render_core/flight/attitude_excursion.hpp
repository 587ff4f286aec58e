/// How far the attitude went, with a play of kPlay on the way back: by it a picture for unusual attitudes begins beyond a limit,
/// and ends kPlay within it, for any limit.
///
/// Each value is the output of a play operator (Krasnosel'skii and Pokrovskii 1989, "Systems with Hysteresis", chapter 2): it
/// rises with its angle, and falls only when the angle is kPlay below it. The tracker steps it at even times, so that it does not
/// depend on the frames that are drawn. Plain data; a copy is a checkpoint. Thread one.
#pragma once

#include <type_traits>

#include "render_core/base/units.hpp"

namespace tedavis::flight {

struct AttitudeExcursion {
    static constexpr double kPlay_rad = base::radians(5);

    double pitch_up_rad = 0, pitch_down_rad = 0;  ///< nose up, nose down
    double bank_rad = 0;                          ///< to either side, 0 or more

    /// NaN: the angle is not known, and what comes after it begins anew.
    void step(double pitch_rad, double roll_rad) noexcept;
};
static_assert(std::is_trivially_copyable_v<AttitudeExcursion>);

}  // namespace tedavis::flight
