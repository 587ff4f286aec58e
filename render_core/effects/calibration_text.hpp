/// Writes the calibration file that read_calibration() reads, from measurements: for the desk's `tedavis calibrate` and the
/// board's `tedavis-display --calibrate`. Nothing else writes this file.
///
/// Pure. Thread  any. Memory  none; everything is of fixed size.
#pragma once

#include "render_core/effects/calibration.hpp"
#include "render_core/effects/quality_front.hpp"

namespace tedavis::effects {

struct MeasuredCost {
    base::FixedString<31> name;  ///< of an effect or an overhead
    CostLine line;
    double ms = 0, spread_ms = 0;   ///< cost per frame, and half of the distance between its quartiles
    base::FixedString<127> design;  ///< design that requested the effect
    base::FixedString<127> note;    ///< why it was not measured; empty where it was
};

struct MeasuredCosts {
    CalibrationSubject subject;
    base::FixedString<31> program;           ///< command that measured: "tedavis calibrate"
    base::FixedString<31> date;              ///< UTC
    base::FixedString<511> design, terrain;  ///< with which costs were measured
    std::uint32_t rounds = 0;
    base::FixedVector<MeasuredCost, kEffectCount + kOverheads> costs;
    QualityCandidates candidates;  ///< of quality levels, the design's own picture first; at least that one
};

/// Has room for the longest file; a test writes that.
using CalibrationText = base::FixedString<32767>;

/// Replaces `text` by the file; quality levels are those of choose_levels().
void write_calibration(const MeasuredCosts& measured, CalibrationText& text);

}  // namespace tedavis::effects
