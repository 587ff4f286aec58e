/// The calibration subject of a display: measured costs are valid for displays with the same device, renderer and picture size.
#pragma once

#include "render_core/display/display.hpp"
#include "render_core/effects/calibration.hpp"

namespace tedavis::display {

/// Returns the subject of a display, which must have been started.
[[nodiscard]] effects::CalibrationSubject calibration_subject(Display& display);

}  // namespace tedavis::display
