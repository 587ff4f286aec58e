/// The data of a picture for its readings.
#pragma once

#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/evaluation/picture_meter.hpp"

namespace tedavis::host_sim {

/// Valid for one picture.
struct MeasuredFrame {
    const FlightFrame& frame;
    const RgbaPicture& picture;
    const LayerMask* mask;  ///< null: the run has none
    const PictureMeasures& measures;
    PictureMeter& meter;  ///< has measured this picture last
};

}  // namespace tedavis::host_sim
