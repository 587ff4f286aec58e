/// Checkpoints along a recorded log: where to go on reading, and the state assembled up to there. Going on from the last
/// checkpoint at or before T gives exactly what a run from the start gives at T, without reading what lies before.
///
/// Thread  one. Memory  the caller's checkpoints, allocated at start. Failure  a medium that fails ends the indexing;
/// the source's health says so.
#pragma once

#include "bus/candump/candump_log_source.hpp"
#include "bus/frame/thinning_index.hpp"
#include "bus/state/state_assembler.hpp"

namespace tedavis::bus {

struct ReplayCheckpoint {
    base::Time newest;  ///< newest stamp of all frames before the checkpoint
    LogPosition position;
    StateAssembler assembler;
};

class ReplayIndex {
public:
    /// `checkpoints` of at least two; 64 keep seeking short in a log of any length.
    ReplayIndex(CandumpLogSource& source, const BusSettings& settings, base::Span<ReplayCheckpoint> checkpoints);

    /// Reads on by up to `frames` frames; false once the log is read. Call until false; in between a program may show
    /// progress (source.position().offset) or stop.
    [[nodiscard]] bool extend(std::uint64_t frames);

    struct Extent {
        base::Time first;
        base::Time last;
        std::uint64_t frames = 0;  ///< 0: the log has no frames, the times mean nothing
    };
    [[nodiscard]] const Extent& extent() const { return extent_; }

    /// Sets the source to the last checkpoint at or before `time` and returns the state there; feed it the frames that the
    /// source then gives up to `time`.
    [[nodiscard]] StateAssembler seek(base::Time time);

private:
    CandumpLogSource& source_;
    BusSettings settings_;
    LogPosition start_;
    ThinningIndex<ReplayCheckpoint> index_;
    StateAssembler assembler_;
    Extent extent_;
    std::uint64_t since_checkpoint_ = 0;
};

}  // namespace tedavis::bus
