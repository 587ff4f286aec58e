/// Port: who else receives the frames that a tracker reads, such as one who counts or answers them.
#pragma once

#include "bus/frame/can_frame.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

class FrameListener {
public:
    virtual ~FrameListener() = default;
    /// Frames in the order of their source, each once; possibly none.
    virtual void receive(base::Span<const CanFrame> frames) = 0;
};

}  // namespace tedavis::bus
