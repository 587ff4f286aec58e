/// Costs that were measured hold for a display where device, renderer and size of the picture are the same.
#pragma once

#include "render_core/display/display.hpp"
#include "render_core/effects/calibration.hpp"

namespace tedavis::display {

/// Of a display that has been started.
[[nodiscard]] effects::CalibrationSubject calibration_subject(Display& display);

}  // namespace tedavis::display
