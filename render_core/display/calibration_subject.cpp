#include "render_core/display/calibration_subject.hpp"

namespace tedavis::display {

effects::CalibrationSubject calibration_subject(Display& display) {
    const DisplaySettings& settings = display.planner().settings();
    return {settings.device.name, display.gl().driver().renderer, settings.width_px, settings.height_px};
}

}  // namespace tedavis::display
