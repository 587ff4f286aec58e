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
    const std::int64_t earliest = std::max<std::int64_t>(frame - window, 0);
    for (std::int64_t planned = earliest; planned < std::max(frame, earliest + 1); ++planned) {
        const base::Time instant_time =
            is_on_grid ? grid_time(planned) : std::max(grid_time(planned) + off_grid, player_.first());
        const PlayedInstant instant = player_.at(instant_time);
        if (planned == earliest)
            display_.settle(instant.aircraft, instant.phase, instant_time);
        else
            display_.approach(instant.aircraft, instant.phase, instant_time);
    }
}

}  // namespace tedavis::host_sim
