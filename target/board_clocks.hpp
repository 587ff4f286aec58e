/// The board's clocks: they stamp the live sources' data and pace the frames.
#pragma once

#include "bus/socketcan/socketcan_source.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::target {

struct BoardClocks {
    bus::LiveClocks live;
    /// Returns at `time` of the monotonic clock, or earlier when a signal arrives.
    void (*sleep_until)(base::Time time) = nullptr;
};

/// Returns the machine's clocks. Never allocates.
[[nodiscard]] BoardClocks machine_clocks() noexcept;

}  // namespace tedavis::target
