#include "host_sim/reports/run_story.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

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

/// The main aspect of the greatest weight; "all" where several have it.
std::string first_aspect(const display::FrameRecord& record) {
    std::string first = "all";
    double greatest = -1;
    for (std::size_t n = 0; n < std::min(record.weights.size(), design::kMainAspects); ++n) {
        const double weight = record.weights[n].weight;
        if (weight == greatest) first = "all";
        if (weight <= greatest) continue;
        greatest = weight;
        first = design::kMainAspectNames[n];
    }
    return first;
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
                            record.own_ship.state == base::SignalState::valid, std::isfinite(height_above_terrain_m),
                            base::degrees(record.own_ship.position.latitude_rad),
                            base::degrees(record.own_ship.position.longitude_rad)});
        if (samples_.size() == kMaxSamples) {
            halve(samples_);
            sample_stride_ *= 2;
        }
    }
    add_phase(record, time_s);
    add_utc(record.flight_time, time_s);
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
    const std::string design(record.design.view()), first = first_aspect(record);
    const auto is_same = [&](const PhaseSpan& last) {
        return last.phase == phase && last.source == source && last.design == design && last.first == first;
    };
    const bool same = !phases_.empty() && is_same(phases_.back());
    if (!same && phases_.size() < kMaxPhases) phases_.push_back({time_s, time_s, phase, source, design, first});
}

void RunStory::add_utc(const flight::FlightTime& time, double time_s) {
    if (!time.is_date) return;
    if (!utc_.is_known) utc_.from_run = time.utc - (base::Time{} + base::Duration::from_seconds(time_s));
    utc_.begin = utc_.is_known ? std::min(utc_.begin, time.utc) : time.utc;
    utc_.end = utc_.is_known ? std::max(utc_.end, time.utc) : time.utc;
    utc_.is_known = true;
    utc_.is_confirmed = utc_.is_confirmed && time.is_confirmed;
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
