/// Writes the file that effects::read_calibration reads, and the same with the measurements as JSON.
#pragma once

#include <string>
#include <vector>

#include "host_sim/measure/quality_front.hpp"
#include "render_core/effects/calibration.hpp"

namespace tedavis::host_sim {

struct MeasuredCost {
    std::string name;  ///< of an effect or an overhead
    effects::CostLine line;
    double ms = 0, spread_ms = 0;  ///< as measured
    std::string design;            ///< that called for it
    std::string note;              ///< why it was not measured; empty: it was
};

struct MeasuredCosts {
    effects::CalibrationSubject subject;
    std::string date, design, terrain;
    std::uint32_t rounds = 0;
    std::vector<MeasuredCost> costs;
    std::vector<QualityCandidate> candidates;  ///< of quality levels, the design's own picture first; at least that one
};

[[nodiscard]] std::string calibration_toml(const MeasuredCosts& measured);
[[nodiscard]] std::string calibration_json(const MeasuredCosts& measured);

}  // namespace tedavis::host_sim
