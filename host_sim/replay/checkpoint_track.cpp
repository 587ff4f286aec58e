#include "host_sim/replay/checkpoint_track.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "host_sim/user_error.hpp"
#include "render_core/base/check.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kQuickCompression = 1;

std::string packed(const FlightProgress& progress) {
    uLongf size = compressBound(sizeof progress);
    std::string bytes(size, '\0');
    const int code = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(&progress),
                               sizeof progress, kQuickCompression);
    TEDAVIS_CHECK(code == Z_OK);
    bytes.resize(size);
    bytes.shrink_to_fit();
    return bytes;
}

bool later(base::Time time, const PackedCheckpoint& checkpoint) { return time < checkpoint.reached; }

}  // namespace

void CheckpointTrack::offer(const FlightProgress& progress) {
    if (!due(progress)) return;
    if (checkpoints_.size() >= spacing_.most) thin();
    checkpoints_.push_back({progress.reached, progress.position.offset, progress.steps_run, packed(progress)});
}

bool CheckpointTrack::due(const FlightProgress& progress) const {
    if (checkpoints_.empty()) return true;
    const PackedCheckpoint& last = checkpoints_.back();
    if (progress.reached <= last.reached) return false;
    return progress.position.offset - last.log_offset >= spacing_.log_bytes * stride_ ||
           progress.steps_run - last.steps_run >= spacing_.steps * stride_;
}

void CheckpointTrack::thin() {
    std::size_t kept = 1;
    for (std::size_t n = 2; n < checkpoints_.size(); n += 2) checkpoints_[kept++] = std::move(checkpoints_[n]);
    checkpoints_.resize(kept);
    stride_ *= 2;
}

const PackedCheckpoint& CheckpointTrack::at_or_before(base::Time time) const {
    TEDAVIS_CHECK(!checkpoints_.empty());
    const auto next = std::upper_bound(checkpoints_.begin(), checkpoints_.end(), time, later);
    return next == checkpoints_.begin() ? *next : *(next - 1);
}

base::Time CheckpointTrack::reached_by(base::Time time) const { return at_or_before(time).reached; }

FlightProgress CheckpointTrack::unpack(base::Time time) const {
    const std::string& bytes = at_or_before(time).bytes;
    FlightProgress progress;
    alignas(FlightProgress) unsigned char plain[sizeof(FlightProgress)];
    uLongf size = sizeof plain;
    const int code = uncompress(plain, &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    if (code != Z_OK || size != sizeof plain) throw UserError("a checkpoint of the replay is damaged; delete the .tdx file");
    std::memcpy(&progress, plain, sizeof progress);
    return progress;
}

void CheckpointTrack::drop_after(base::Time time) {
    while (checkpoints_.size() > 1 && checkpoints_.back().reached > time) checkpoints_.pop_back();
}

}  // namespace tedavis::host_sim
