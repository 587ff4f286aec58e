/// What one pass over a recorded flight found: its extent, what was counted, and checkpoints to go on from. It is kept
/// beside the log as LOG.tdx, so that the next replay starts anywhere at once.
///
/// The file is a cache of this machine and this build: native byte order, the checkpoints as they lie in memory. One
/// checksum covers all of it, and it says what it was made from; anything that does not fit is made anew.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/replay/checkpoint_track.hpp"
#include "host_sim/replay/flight_outline.hpp"
#include "host_sim/replay/index_key.hpp"

namespace tedavis::host_sim {

struct FlightIndex {
    LogFacts facts;
    CheckpointTrack track;
    FlightOutline outline;
};

[[nodiscard]] std::string pack_index(const FlightIndex& index, const IndexKey& key);

struct UnpackedIndex {
    std::optional<FlightIndex> index;
    std::string refusal;  ///< why there is none, to follow "it ": "is damaged", "was made from another log"
};
[[nodiscard]] UnpackedIndex unpack_index(std::string_view bytes, const IndexKey& key, const CheckpointSpacing& spacing);

}  // namespace tedavis::host_sim
