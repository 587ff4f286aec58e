#include "host_sim/replay/frame_approach.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {

base::Time FrameApproach::grid_time(std::int64_t frame) const {
    return player_.first() + base::Duration::from_seconds(static_cast<double>(frame) / rate_hz_);
}

void FrameApproach::approach(base::Time time) {
    const auto frame = static_cast<std::int64_t>(std::llround((time - player_.first()).to_seconds() * rate_hz_));
    const base::Duration off_grid = time - grid_time(frame);
    const bool is_on_grid = std::abs(off_grid.ns) <= 1;
    const bool follows = is_on_grid && last_ && frame == *last_ + 1;
    last_ = is_on_grid ? std::optional<std::int64_t>(frame) : std::nullopt;
    if (follows) return;
    const std::int64_t window = terrain::StoreSettings().window_frames;
    for (std::int64_t planned = frame - window; planned < frame; ++planned) {
        const base::Time grid = grid_time(std::max<std::int64_t>(planned, 0));
        const base::Time instant_time = is_on_grid ? grid : std::max(grid + off_grid, player_.first());
        const PlayedInstant instant = player_.at(instant_time);
        display_.approach(instant.aircraft, instant.phase, instant_time, &player_.way());
    }
}

}  // namespace tedavis::host_sim
