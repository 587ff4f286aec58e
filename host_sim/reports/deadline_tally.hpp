/// Counts the frames of a run that met their deadline, by modelled and by measured times, and the changes of quality level.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "host_sim/reports/frame_record_json.hpp"
#include "render_core/effects/quality_level.hpp"

namespace tedavis::host_sim {

struct DeadlineSummary {
    double deadline_ms = 0;  ///< 0: the run had none
    std::uint64_t frames = 0, within_modelled = 0, within_measured = 0;
    std::uint64_t changes = 0;
    std::optional<double> least_s_between_changes;  ///< nothing: fewer than two
    /// For each level of the calibration file; levels that it lacks have 0.
    std::array<std::uint64_t, effects::kQualityLevelCount> frames_at_quality_level{};
};

class DeadlineTally {
public:
    void add(const FrameResult& result);
    [[nodiscard]] const DeadlineSummary& summary() const { return summary_; }

private:
    DeadlineSummary summary_;
    std::optional<base::Time> last_change_;
};

/// "; deadline 33 ms: 99.80 % of frames within by the model, 97.10 % as measured, 14 changes at least 2.0 s apart"; empty where
/// the run had none.
[[nodiscard]] std::string deadline_text(const DeadlineSummary& summary);

}  // namespace tedavis::host_sim
