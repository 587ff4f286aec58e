/// Checkpoints along a flight, packed, in memory of a bounded size: when it is full every second one goes and the spacing
/// doubles. The first one stays.
///
/// Spacing is by bytes of log and by steps of the phase, whichever comes first, so that playing on from a checkpoint to any
/// instant before the next one takes about the same short time in busy and in quiet recordings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/replay/flight_progress.hpp"

namespace tedavis::host_sim {

struct CheckpointSpacing {
    std::uint64_t log_bytes = 8u << 20;
    std::uint64_t steps = 15000;  ///< five minutes
    std::size_t most = 512;       ///< checkpoints kept, at least 2
};

struct PackedCheckpoint {
    base::Time reached;
    std::uint64_t log_offset = 0;
    std::uint64_t steps_run = 0;
    std::string bytes;  ///< FlightProgress, compressed
};

class CheckpointTrack {
public:
    explicit CheckpointTrack(const CheckpointSpacing& spacing = CheckpointSpacing()) : spacing_(spacing) {}
    /// Takes up where an earlier track ended; `stride` is that track's.
    CheckpointTrack(const CheckpointSpacing& spacing, std::uint64_t stride, std::vector<PackedCheckpoint> checkpoints)
        : spacing_(spacing), stride_(stride), checkpoints_(std::move(checkpoints)) {}

    /// Adds a checkpoint if it lies beyond the last one by the spacing, or is the first.
    void offer(const FlightProgress& progress);
    /// When the last checkpoint at or before `time` was made; the first one's time where all are later. Not when empty.
    [[nodiscard]] base::Time reached_by(base::Time time) const;
    /// That checkpoint; throws UserError if its bytes are damaged.
    [[nodiscard]] FlightProgress unpack(base::Time time) const;
    /// Forgets what lies after `time`, except the first.
    void drop_after(base::Time time);

    [[nodiscard]] const std::vector<PackedCheckpoint>& checkpoints() const { return checkpoints_; }
    /// How often the spacing is taken: 1, 2, 4, ...
    [[nodiscard]] std::uint64_t stride() const { return stride_; }

private:
    [[nodiscard]] bool due(const FlightProgress& progress) const;
    [[nodiscard]] const PackedCheckpoint& at_or_before(base::Time time) const;
    void thin();

    CheckpointSpacing spacing_;
    std::uint64_t stride_ = 1;
    std::vector<PackedCheckpoint> checkpoints_;
};

}  // namespace tedavis::host_sim
