/// Chooses the quality levels of a calibration from measured candidates.
///
/// Pure. Thread  any. Memory  none; lists are of fixed size.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/effects/quality_level.hpp"

namespace tedavis::effects {

/// A quality level as it was measured.
struct QualityCandidate {
    QualityLevel level;
    double spread_ms = 0;  ///< half of the distance between the quartiles of what it saves
};

inline constexpr std::size_t kMaxQualityCandidates = 48;
using QualityCandidates = base::FixedVector<QualityCandidate, kMaxQualityCandidates>;

/// Returns the candidates that no other one dominates, by falling time. The first candidate, the design's own picture, is always
/// the first of them. Of candidates with the same errors the first one in the list counts: their times differ by noise.
[[nodiscard]] QualityCandidates pareto_front(const QualityCandidates& candidates);

/// Returns at most kQualityLevelCount levels of the front, the design's own picture first. Their times are to fall by equal
/// factors down to the cheapest candidate: for each of these times the level is chosen that keeps no more than the one before,
/// saves more than the noise, and has the smallest difference of color (then the smallest error of terrain). The result
/// satisfies fault_of().
[[nodiscard]] QualityLevels choose_levels(const QualityCandidates& candidates);

}  // namespace tedavis::effects
