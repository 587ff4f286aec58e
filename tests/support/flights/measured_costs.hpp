/// Costs and quality levels as a calibration might measure them: every line differs, texts need quoting, and one of the four
/// candidates of quality levels is dominated.
#pragma once

#include "render_core/effects/calibration_text.hpp"

namespace tedavis::test_support {

inline effects::MeasuredCost measured_cost(std::string_view name, const effects::CostLine& line) {
    effects::MeasuredCost cost;
    cost.name = name;
    cost.line = line;
    cost.ms = line.fixed_ms;
    cost.spread_ms = 0.1;
    cost.design = "x";
    return cost;
}

inline void add_candidates(effects::MeasuredCosts& m) {
    effects::EffectSet edges;
    edges.add(effects::Effect::antialiasing);
    edges.add(effects::Effect::silhouettes);
    for (const effects::QualityCandidate& candidate :
         {effects::QualityCandidate{{1, 1, {}, 40, 1, 0}, 0}, effects::QualityCandidate{{1, 1, edges, 30, 1, 0.5}, 1},
          effects::QualityCandidate{{2, 0.5, {}, 45, 2, 1}, 1}, effects::QualityCandidate{{2, 0.5, edges, 20.5, 2.25, 1.25}, 1}})
        static_cast<void>(m.candidates.try_push_back(candidate));
}

inline effects::MeasuredCosts measured_costs() {
    effects::MeasuredCosts m;
    m.subject = {"es3-mid", "llvmpipe \"quoted\" \\ (LLVM)", 1024, 768};
    m.program = "tedavis calibrate";
    m.date = "2026-11-22T22:57:48Z";
    m.design = "default";
    m.terrain = "a\nb.tdb";
    m.rounds = 9;
    double ms = 0.125;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n, ms += 0.125)
        static_cast<void>(
            m.costs.try_push_back(measured_cost(effects::row_of(static_cast<effects::Effect>(n)).name, {ms, ms / 2, 3})));
    for (const std::string_view name : effects::kOverheadNames)
        static_cast<void>(m.costs.try_push_back(measured_cost(name, {1, 2, 3})));
    m.costs[2].note = "the view\nhas none";
    add_candidates(m);
    return m;
}

}  // namespace tedavis::test_support
