/// The measurements of a calibration as JSON, with all candidates of quality levels; the calibration file itself is written by
/// effects::write_calibration.
#pragma once

#include <string>

#include "render_core/effects/calibration_text.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::string calibration_json(const effects::MeasuredCosts& measured);

}  // namespace tedavis::host_sim
