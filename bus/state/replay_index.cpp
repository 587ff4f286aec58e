#include "bus/state/replay_index.hpp"

#include <limits>

namespace tedavis::bus {
namespace {

constexpr std::uint64_t kFirstStride = 4096;
constexpr std::size_t kBatch = 256;
constexpr base::Time kEndOfTime{std::numeric_limits<std::int64_t>::max()};

}  // namespace

ReplayIndex::ReplayIndex(CandumpLogSource& source, const BusSettings& settings, base::Span<ReplayCheckpoint> checkpoints)
    : source_(source), settings_(settings), start_(source.position()), index_(checkpoints, kFirstStride), assembler_(settings) {}

bool ReplayIndex::extend(std::uint64_t frames) {
    CanFrame batch[kBatch];
    for (std::uint64_t done = 0; done < frames;) {
        const std::size_t count = source_.read(kEndOfTime, batch);
        if (count == 0) return false;
        if (extent_.frames == 0) extent_.first = batch[0].time;
        assembler_.feed({batch, count});
        assembler_.note_dropped(source_.statistics().dropped);
        extent_.frames += count;
        extent_.last = source_.position().newest;
        since_checkpoint_ += count;
        done += count;
        if (!index_.due(since_checkpoint_)) continue;
        index_.add({source_.position().newest, source_.position(), assembler_});
        since_checkpoint_ = 0;
    }
    return true;
}

StateAssembler ReplayIndex::seek(base::Time time) {
    const ReplayCheckpoint* checkpoint = index_.at_or_before(time);
    source_.seek(checkpoint != nullptr ? checkpoint->position : start_);
    return checkpoint != nullptr ? checkpoint->assembler : StateAssembler(settings_);
}

}  // namespace tedavis::bus
