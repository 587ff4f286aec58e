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
    double spread_ms = 0;  ///< half of the distance between the quartiles of the time that it saves
};

inline constexpr std::size_t kMaxQualityCandidates = 48;
using QualityCandidates = base::FixedVector<QualityCandidate, kMaxQualityCandidates>;

/// Returns the candidates that no other one dominates, in the order of descending time. The first candidate, the design's own
/// picture, is always the first of them. Of candidates with the same errors only the first one is kept, because their times
/// differ by noise.
[[nodiscard]] QualityCandidates pareto_front(const QualityCandidates& candidates);

/// Returns at most kQualityLevelCount levels of the front, the design's own picture first. Target times fall by equal factors
/// from its time to that of the cheapest candidate. For each target the level is chosen that has the smallest colour difference
/// (then the smallest error of terrain) among candidates within it that keep no more than the level before and save more than the
/// noise; where no such candidate is within the target, the cheapest one is taken. fault_of() finds nothing wrong with the
/// result.
[[nodiscard]] QualityLevels choose_levels(const QualityCandidates& candidates);

}  // namespace tedavis::effects
