/// The picture of a frame, which is drawn on demand, since most conditions of a flight test need none.
#pragma once

#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// The object owns what its functions return; it is valid until the next frame is planned.
class ShownPicture {
public:
    ShownPicture() = default;
    ShownPicture(const ShownPicture&) = delete;
    ShownPicture& operator=(const ShownPicture&) = delete;
    virtual ~ShownPicture() = default;

    /// The pixels, top row first.
    virtual const RgbaPicture& pixels() = 0;
    /// The layer of each pixel.
    virtual const LayerMask& layers() = 0;
    /// The record, as a contract reads it.
    virtual const FlightFrame& frame() = 0;
};

}  // namespace tedavis::host_sim
