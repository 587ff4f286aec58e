#include "host_sim/reports/deadline_tally.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tedavis::host_sim {

void DeadlineTally::add(const FrameResult& result) {
    const display::GovernorRecord& governor = result.record.governor;
    if (!(governor.deadline_ms > 0)) return;
    DeadlineSummary& s = summary_;
    s.deadline_ms = governor.deadline_ms;
    ++s.frames;
    const bool is_known = governor.predicted_ms > 0;
    s.within_modelled += is_known && governor.predicted_ms <= governor.deadline_ms ? 1 : 0;
    s.within_measured += result.timing.total_ms <= governor.deadline_ms ? 1 : 0;
    ++s.frames_at_quality_level[std::min<std::size_t>(governor.quality_level, effects::kQualityLevelCount - 1)];
    if (!governor.changed) return;
    ++s.changes;
    if (last_change_) {
        const double apart_s = std::abs((result.record.time - *last_change_).to_seconds());
        s.least_s_between_changes = std::min(apart_s, s.least_s_between_changes.value_or(apart_s));
    }
    last_change_ = result.record.time;
}

std::string deadline_text(const DeadlineSummary& s) {
    if (s.frames == 0) return {};
    const auto percent = [&](std::uint64_t within) {
        return 100.0 * static_cast<double>(within) / static_cast<double>(s.frames);
    };
    char text[200];
    std::snprintf(text, sizeof text, "; deadline %g ms: %.2f %% of frames within by the model, %.2f %% as measured, %llu changes",
                  s.deadline_ms, percent(s.within_modelled), percent(s.within_measured),
                  static_cast<unsigned long long>(s.changes));
    std::string line = text;
    if (!s.least_s_between_changes) return line;
    std::snprintf(text, sizeof text, " at least %.1f s apart", *s.least_s_between_changes);
    return line + text;
}

}  // namespace tedavis::host_sim
