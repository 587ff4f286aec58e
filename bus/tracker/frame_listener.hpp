/// Port: also receives the frames that a tracker reads, for example to count or to answer them.
#pragma once

#include "bus/frame/can_frame.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

class FrameListener {
public:
    virtual ~FrameListener() = default;
    /// Receives frames in the order of their source, each once; `frames` may be empty.
    virtual void receive(base::Span<const CanFrame> frames) = 0;
};

}  // namespace tedavis::bus
