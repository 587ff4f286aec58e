#include "host_sim/reports/run_story.hpp"

#include <cmath>

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kMaxSamples = 4096;
constexpr std::size_t kMaxThumbnails = 32;
constexpr std::size_t kMaxPhases = 4096;
constexpr std::uint32_t kThumbnailWidth = 192;

std::string phase_text(const display::FrameRecord& record) {
    const std::string sub = flight::sub_phase_name(record.phase.phase);
    return flight::scenario_name(record.phase.phase) + (sub.empty() ? sub : "." + sub);
}

/// Keeps every second element, the first included.
template <class T>
void halve(std::vector<T>& list) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); i += 2, ++kept) {
        if (kept != i) list[kept] = std::move(list[i]);
    }
    list.resize(kept);
}

}  // namespace

bool RunStory::add(const FrameResult& result, double height_above_terrain_m, double ground_speed_mps) {
    const display::FrameRecord& record = result.record;
    const double time_s = (record.time - origin_).to_seconds();
    if (frames_ % sample_stride_ == 0) {
        samples_.push_back({time_s, record.altitude_msl_m, height_above_terrain_m, ground_speed_mps, result.timing.total_ms,
                            record.own_ship.state == base::SignalState::valid, std::isfinite(height_above_terrain_m)});
        if (samples_.size() == kMaxSamples) {
            halve(samples_);
            sample_stride_ *= 2;
        }
    }
    add_phase(record, time_s);
    for (const display::Name& flag : record.flags) {
        FlagSpan& span = flags_.emplace(std::string(flag.view()), FlagSpan{time_s, time_s, 0}).first->second;
        span.last_s = time_s;
        ++span.frames;
    }
    return frames_++ % picture_stride_ == 0;
}

void RunStory::add_phase(const display::FrameRecord& record, double time_s) {
    const std::string phase = phase_text(record), source = flight::to_string(record.phase.source);
    if (!phases_.empty()) phases_.back().end_s = time_s;
    const bool same = !phases_.empty() && phases_.back().phase == phase && phases_.back().source == source;
    if (!same && phases_.size() < kMaxPhases) phases_.push_back({time_s, time_s, phase, source});
}

void RunStory::add_picture(const FrameResult& result, const RgbaView& view) {
    const double time_s = (result.record.time - origin_).to_seconds();
    thumbnails_.push_back(
        {result.record.frame, time_s, phase_text(result.record), encode_png(view_of(shrunk(view, kThumbnailWidth)))});
    if (thumbnails_.size() < kMaxThumbnails) return;
    halve(thumbnails_);
    picture_stride_ *= 2;
}

void RunStory::add_legend(const std::string& design, bool is_whole, const FrameResult& result, const RgbaView& view) {
    const double time_s = (result.record.time - origin_).to_seconds();
    legends_.push_back({design, is_whole, result.record.frame, time_s, phase_text(result.record), encode_small_png(view)});
}

}  // namespace tedavis::host_sim
