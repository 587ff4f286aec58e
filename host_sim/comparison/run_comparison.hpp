/// The differences of two runs over their aligned instants.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/comparison/alignment.hpp"
#include "host_sim/comparison/closest_of_run.hpp"

namespace tedavis::host_sim {

/// The difference of a quantity over the instants in which both runs have it; at least one.
struct QuantityDifference {
    std::size_t quantity = 0;  ///< index into kQuantities
    std::size_t count = 0;     ///< number of these instants
    /// Number of values in means and medians: for flown quantities that of the instants, else that of the distinct nearest frames
    /// of each run.
    std::size_t values_a = 0, values_b = 0;
    double mean_a = 0, mean_b = 0, median_a = 0, median_b = 0;
    /// The smallest values and their instants; for heights and distances, in flight alone, with a known phase. NaN where there is
    /// none.
    double least_a = std::numeric_limits<double>::quiet_NaN(), least_b = std::numeric_limits<double>::quiet_NaN();
    std::size_t least_a_at = 0, least_b_at = 0;
    double greatest = 0;          ///< B - A where its magnitude is largest
    std::size_t greatest_at = 0;  ///< its instant

    [[nodiscard]] double sum_a() const { return mean_a * static_cast<double>(values_a); }
    [[nodiscard]] double sum_b() const { return mean_b * static_cast<double>(values_b); }
};

/// Frames in which an effect was drawn, of those that are compared.
struct EffectDifference {
    std::string name;
    std::size_t frames_a = 0, frames_b = 0;
    double share_a = 0, share_b = 0;  ///< of the frames that are compared
};

/// Frames by level of an alert: none, caution, warning.
using AlertLevels = std::array<std::size_t, 3>;

struct RunComparison {
    ComparedRun a, b;
    AlignedRuns aligned;
    std::vector<std::size_t> compared_a, compared_b;  ///< indices of the frames that are compared, each once
    std::optional<RunClosest> closest_a, closest_b;   ///< of each whole run, independent of the alignment
    std::vector<QuantityDifference> quantities;       ///< in the order of kQuantities
    /// Number of instants in which only one run has the quantity, by the index into kQuantities.
    std::array<std::size_t, kQuantityCount> known_by_one{};
    std::vector<EffectDifference> effects;  ///< effects that either run drew, those with the greatest difference of shares first
    AlertLevels terrain_a{}, terrain_b{}, obstacles_a{}, obstacles_b{};
    std::size_t other_phase = 0;                   ///< instants of different flight phases
    std::optional<std::size_t> first_other_phase;  ///< the first of them
    std::size_t known_pictures = 0;                ///< instants in which both records have the hash of their picture
    std::size_t equal_pictures = 0;                ///< of these, instants whose pictures have equal pixels, by their hashes
    /// Differences of the summaries: {"design", "default", "cruise"}.
    struct Setting {
        std::string name, a, b;
    };
    std::vector<Setting> settings;

    [[nodiscard]] const ComparedFrame& frame_a(std::size_t instant) const { return a.frames[aligned.instants[instant].a]; }
    /// The frame that is nearest to the instant.
    [[nodiscard]] const ComparedFrame& frame_b(std::size_t instant) const {
        return b.frames[aligned.instants[instant].nearest_b()];
    }
    [[nodiscard]] double value_a(std::size_t instant, std::size_t quantity) const {
        return a.frames[aligned.instants[instant].a].values[quantity];
    }
    [[nodiscard]] double value_b(std::size_t instant, std::size_t quantity) const {
        return value_at(b, aligned.instants[instant].b, quantity);
    }
    [[nodiscard]] const QuantityDifference* find(std::size_t quantity) const;
    /// True where its greatest difference is 0 and both know the quantity in the same instants.
    [[nodiscard]] bool has_equal(std::size_t quantity) const;
    /// True where no instant has a difference in anything that is compared. Times per frame are measured and do not count;
    /// pictures count in the instants of `known_pictures`, which may be none.
    [[nodiscard]] bool is_equal() const;
};

/// Throws UserError where the runs cannot be aligned.
[[nodiscard]] RunComparison compared_runs(ComparedRun a, ComparedRun b, const AlignmentRequest& request);

}  // namespace tedavis::host_sim
