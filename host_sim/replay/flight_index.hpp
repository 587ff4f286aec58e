/// The result of one pass over a recorded flight: its extent, counts, and checkpoints from which it can be played. It is stored
/// beside the log as LOG.tdx, so that the next replay starts at any time without delay.
///
/// The file is a cache for this machine and this build: native byte order, checkpoints as in memory. It has one checksum and the
/// identity of its sources (IndexKey); where either does not match, the index is made again.
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
    std::string refusal;  ///< why there is none, as the end of a sentence: "is damaged", "was made from another log"
};
[[nodiscard]] UnpackedIndex unpack_index(std::string_view bytes, const IndexKey& key, const CheckpointSpacing& spacing);

}  // namespace tedavis::host_sim
