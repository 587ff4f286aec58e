/// Compressed checkpoints along a flight, in bounded memory: when it is full, every second one is removed and the spacing
/// doubles. The first one is always kept.
///
/// The spacing is a number of bytes of the log or of steps of the tracker, whichever is reached first, so that playing from a
/// checkpoint to any time before the next one takes about equally long in busy and in quiet recordings.
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
    /// Continues an earlier track, whose stride() and checkpoints() are given.
    CheckpointTrack(const CheckpointSpacing& spacing, std::uint64_t stride, std::vector<PackedCheckpoint> checkpoints)
        : spacing_(spacing), stride_(stride), checkpoints_(std::move(checkpoints)) {}

    /// Adds a checkpoint if it lies beyond the last one by the spacing, or is the first.
    void offer(const FlightProgress& progress);
    /// The time of the last checkpoint at or before `time`, or of the first one where all are later. The track must not be empty.
    [[nodiscard]] base::Time reached_by(base::Time time) const;
    /// Returns this checkpoint. Throws UserError if its bytes are damaged.
    [[nodiscard]] FlightProgress unpack(base::Time time) const;
    /// Removes the checkpoints after `time`, except the first.
    void drop_after(base::Time time);

    [[nodiscard]] const std::vector<PackedCheckpoint>& checkpoints() const { return checkpoints_; }
    /// The factor of the spacing: 1, 2, 4, ...
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
