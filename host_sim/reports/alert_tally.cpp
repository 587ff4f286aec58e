#include "host_sim/reports/alert_tally.hpp"

#include <algorithm>
#include <numeric>

namespace tedavis::host_sim {
namespace {

using policy::TerrainAhead;

constexpr double kLongestFrame_s = 10;  // longer gaps are none of a flight

}  // namespace

std::uint64_t TerrainAlertCounts::frames() const { return std::accumulate(frames_by.begin(), frames_by.end(), std::uint64_t{0}); }

void AlertTally::add(const display::FrameRecord& record) {
    const double time_s = (record.time - base::Time{}).to_seconds();
    if (!frames_.empty() && !(time_s > frames_.back().time_s)) return;
    const display::AlertRecord& alerts = record.alerts;
    frames_.push_back(
        {time_s, alerts.height_above_terrain_m, alerts.clearance_m, alerts.terrain, alerts.is_watching, hindrance_of(record)});
}

/// Until the next frame; the last one is as long as the one before.
double AlertTally::seconds_of(std::size_t n) const {
    if (frames_.size() < 2) return 0;
    const std::size_t from = std::min(n, frames_.size() - 2);
    const double seconds = frames_[from + 1].time_s - frames_[from].time_s;
    return seconds <= kLongestFrame_s ? seconds : 0;
}

bool AlertTally::is_confirmed(std::size_t n, double within_s) const {
    const Frame& alerted = frames_[n];
    for (std::size_t later = n; later < frames_.size(); ++later) {
        const Frame& flown = frames_[later];
        if (flown.time_s > alerted.time_s + within_s || (later > n && !flown.is_watching)) return false;
        if (flown.height_m < alerted.clearance_m) return true;
    }
    return false;
}

void AlertTally::count_time(TerrainAlertCounts& counts) const {
    for (std::size_t n = 0; n < frames_.size(); ++n) {
        const double hours = seconds_of(n) / 3600;
        const auto why = static_cast<std::size_t>(frames_[n].hindrance);
        counts.hours += hours;
        counts.hours_by[why] += hours;
        ++counts.frames_by[why];
        counts.has_gaps = counts.has_gaps || hours == 0;
    }
}

void AlertTally::count_alert(std::size_t begin, std::size_t end, TerrainAlertCounts& counts) const {
    bool warned = false, is_true = false, is_true_warning = false;
    for (std::size_t n = begin; n < end; ++n) {
        const bool warns = frames_[n].level == TerrainAhead::warning;
        (warns ? counts.seconds_warning : counts.seconds_caution) += seconds_of(n);
        warned = warned || warns;
        is_true = is_true || is_confirmed(n, policy::kTerrainCaution_s);
        is_true_warning = is_true_warning || (warns && is_confirmed(n, policy::kTerrainWarning_s));
    }
    ++counts.count;
    counts.false_count += is_true ? 0 : 1;
    counts.warnings += warned ? 1 : 0;
    counts.false_warnings += warned && !is_true_warning ? 1 : 0;
}

TerrainAlertCounts AlertTally::counts() const {
    TerrainAlertCounts counts;
    count_time(counts);
    for (std::size_t begin = 0; begin < frames_.size(); ++begin) {
        if (frames_[begin].level == TerrainAhead::none) continue;
        std::size_t end = begin + 1;
        while (end < frames_.size() && frames_[end].level != TerrainAhead::none) ++end;
        count_alert(begin, end, counts);
        begin = end;
    }
    return counts;
}

}  // namespace tedavis::host_sim
