#include "host_sim/replay/frame_approach.hpp"

namespace tedavis::host_sim {

void FrameApproach::approach(std::uint64_t n) {
    const bool follows = last_ && n == *last_ + 1;
    last_ = n;
    if (follows) return;
    const std::uint64_t window = terrain::StoreSettings().window_frames, earlier = instants_.earlier(n, window);
    for (std::uint64_t back = earlier; back > 0; --back)
        plan(instants_.earlier_at(n, back), back == earlier ? window - earlier : 0);
    if (earlier == 0) plan(instants_.earlier_at(n, 0), window - 1);
}

void FrameApproach::plan(base::Time time, std::uint64_t again) {
    const PlayedInstant instant = player_.at(time);
    for (std::uint64_t planned = 0; planned <= again; ++planned) display_.approach(instant.aircraft, instant.phase, time);
}

}  // namespace tedavis::host_sim
