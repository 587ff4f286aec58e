/// Whether two runs rank the levels of their knobs alike: Kendall's tau (Kendall, "A New Measure of Rank Correlation", Biometrika
/// 30, 1938) over all pairs of levels of a knob that neither run's noise hides, by median time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

struct RankAgreement {
    /// Medians that differ by more than this share of the smaller should be ranked.
    static constexpr double kDistinct = 0.1;

    std::uint64_t common = 0;    ///< pairs of levels that both runs have
    std::uint64_t pairs = 0;     ///< of these, that both runs rank
    std::uint64_t alike = 0;     ///< of these, in the same order
    std::uint64_t distinct = 0;  ///< pairs whose medians differ by more than kDistinct in the newer run
    std::uint64_t ranked = 0;    ///< of these, not hidden by its noise

    /// Counts the pairs of levels that both knobs have.
    void add(const MeasuredKnob& knob, const MeasuredKnob& earlier);

    /// -1 (all in the opposite order) to 1 (all alike); nothing without pairs.
    [[nodiscard]] std::optional<double> tau() const;
};

/// "Both rank 41 pairs of levels, 40 of them alike (Kendall's tau 0.951). Of 50 pairs whose medians differ by more than 10 % in
/// this run, its noise leaves 45 ranked."
[[nodiscard]] std::string rank_text(const RankAgreement& ranks);

}  // namespace tedavis::host_sim
