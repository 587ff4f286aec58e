#include "host_sim/replay/frame_approach.hpp"

#include <algorithm>

namespace tedavis::host_sim {

void FrameApproach::approach(std::uint64_t n) {
    const bool follows = last_ && n == *last_ + 1;
    last_ = n;
    if (follows) return;
    const std::uint64_t earlier = instants_.earlier(n, terrain::StoreSettings().window_frames);
    for (std::uint64_t planned = 0; planned < std::max<std::uint64_t>(earlier, 1); ++planned) {
        const base::Time time = instants_.earlier_at(n, earlier - planned);
        const PlayedInstant instant = player_.at(time);
        if (planned == 0)
            display_.settle(instant.aircraft, instant.phase, time);
        else
            display_.approach(instant.aircraft, instant.phase, time);
    }
}

}  // namespace tedavis::host_sim
