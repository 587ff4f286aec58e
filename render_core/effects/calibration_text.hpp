/// Writes the calibration file that read_calibration() reads, from what was measured: the only writer of it, for the desk's
/// `tedavis calibrate` and the board's `tedavis-display --calibrate`.
///
/// Pure. Thread  any. Memory  none; everything is of fixed size.
#pragma once

#include "render_core/effects/calibration.hpp"
#include "render_core/effects/quality_front.hpp"

namespace tedavis::effects {

struct MeasuredCost {
    base::FixedString<31> name;  ///< of an effect or an overhead
    CostLine line;
    double ms = 0, spread_ms = 0;   ///< as measured
    base::FixedString<127> design;  ///< that called for it
    base::FixedString<127> note;    ///< why it was not measured; empty: it was
};

struct MeasuredCosts {
    CalibrationSubject subject;
    base::FixedString<31> program;  ///< that measured, as a user starts it: "tedavis calibrate"
    base::FixedString<31> date;     ///< UTC
    base::FixedString<511> design, terrain;
    std::uint32_t rounds = 0;
    base::FixedVector<MeasuredCost, kEffectCount + kOverheads> costs;
    QualityCandidates candidates;  ///< of quality levels, the design's own picture first; at least that one
};

/// Holds the longest file: a test writes it.
using CalibrationText = base::FixedString<32767>;

void write_calibration(const MeasuredCosts& measured, CalibrationText& text);

}  // namespace tedavis::effects
