/// The clocks of the board: what the live sources stamp with, and what paces the frames.
#pragma once

#include "bus/socketcan/socketcan_source.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::target {

struct BoardClocks {
    bus::LiveClocks live;
    /// Returns at `time` of the monotonic clock, or earlier when a signal comes.
    void (*sleep_until)(base::Time time) = nullptr;
};

/// The machine's own. Never allocates.
[[nodiscard]] BoardClocks machine_clocks() noexcept;

}  // namespace tedavis::target
