/// The picture of a frame, which is drawn when it is asked for: most conditions of a flight test need none.
#pragma once

#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// Valid until the next frame is planned; what the functions return belongs to it.
class ShownPicture {
public:
    ShownPicture() = default;
    ShownPicture(const ShownPicture&) = delete;
    ShownPicture& operator=(const ShownPicture&) = delete;
    virtual ~ShownPicture() = default;

    /// Top row first.
    virtual const RgbaPicture& pixels() = 0;
    /// The layer of each pixel.
    virtual const LayerMask& layers() = 0;
    /// The record, as a contract reads it.
    virtual const FlightFrame& frame() = 0;
};

}  // namespace tedavis::host_sim
