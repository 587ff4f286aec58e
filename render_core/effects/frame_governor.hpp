/// Holds a frame's deadline by choosing a quality level of quality_level.hpp. It is deterministic: it uses the source's time
/// and modelled costs and reads no clock, so a replay decides as the flight did.
///
/// - A frame whose modelled cost exceeds `act_at` of the deadline changes at once to the richest level below `aim_at` of it,
///   without intermediate levels; where there is none, to the richest one of the cheapest levels. Costs that grow steadily are
///   extrapolated to the time of the next possible change.
/// - A richer level returns when its cost has been below `relax_at` without interruption for the dwell; after a return that
///   did not last the wait is doubled, up to `most_patience` times the dwell.
/// - The dwell must pass between two changes. A frame that is too expensive meanwhile is reported, as is one that no level makes
/// cheaper.
///
/// Pure. Thread  any. Memory  none; the state is plain data of fixed size.
#pragma once

#include <string_view>

#include "render_core/base/time.hpp"
#include "render_core/effects/quality_level.hpp"

namespace tedavis::effects {

struct GovernorSettings {
    base::Duration dwell = base::Duration::seconds(2);
    double act_at = 0.95, aim_at = 0.85, relax_at = 0.75;  ///< of the deadline
    std::uint32_t most_patience = 16;
};

enum class GovernorWhy : std::uint8_t {
    no_deadline,
    cost_unknown,     ///< no calibration: nothing is reduced
    fits,             ///< the design's own picture
    too_dear,         ///< changed to a cheaper level in this frame
    cheaper_for_now,  ///< a richer level would be too expensive, or has not been cheap enough for long enough
    relaxed,          ///< changed to a richer level in this frame
    waits,            ///< too expensive, but the last change was less than the dwell ago
    cheapest_is_too_dear,
    count_
};
/// Returns the text for records and reports.
[[nodiscard]] std::string_view to_string(GovernorWhy why) noexcept;

struct GovernorInput {
    base::Time now;  ///< the source's time; an earlier one than the last resets, the same one decides the same frame again
    double deadline_ms = 0;
    std::array<double, kQualityLevelCount> ms{};   ///< modelled cost of this frame at every level
    std::size_t level_count = kQualityLevelCount;  ///< number of levels that there are, from 1 on
};

struct GovernorDecision {
    std::size_t quality_level = 0;
    bool changed = false;
    GovernorWhy why = GovernorWhy::no_deadline;
};

/// The growth rate of a cost, robust against jumps: the median of the last steps.
class CostTrend {
public:
    void take(base::Time now, double ms);
    /// Returns the factor, at least 1, by which the cost will have grown after `ahead`.
    [[nodiscard]] double growth(double ms, base::Duration ahead) const;

private:
    static constexpr std::size_t kSteps = 8;
    static constexpr base::Duration kStep = base::Duration::milliseconds(125);
    std::array<double, kSteps> ms_per_s_{};
    std::uint8_t next_ = 0;
    bool has_last_ = false;
    base::Time last_time_;
    double last_ms_ = 0;
};

class FrameGovernor {
public:
    FrameGovernor() = default;
    /// A governor that has chosen `quality_level` and has no history.
    explicit FrameGovernor(std::size_t quality_level) { now_.quality_level = static_cast<std::uint8_t>(quality_level); }
    /// Decides the level of a frame; to be called once per frame, with a deadline above 0.
    GovernorDecision decide(const GovernorInput& input, const GovernorSettings& settings = {});
    /// Level of the last decision.
    [[nodiscard]] std::size_t quality_level() const { return now_.quality_level; }

private:
    struct State {
        bool has_begun = false, has_changed = false, has_relaxed = false;
        std::uint8_t quality_level = 0;
        std::uint32_t patience = 1;  ///< number of dwells for which a richer level must have been cheap enough
        base::Time time, last_change, last_relaxed;
        std::array<base::Time, kQualityLevelCount> cheap_since{};  ///< for richer levels
        CostTrend trend;
    };
    void begin(const GovernorInput& input);
    void record_cheap_quality_levels(const GovernorInput& input, const GovernorSettings& settings, double growth);
    GovernorDecision tighten(const GovernorInput& input, const GovernorSettings& settings, double growth);
    GovernorDecision relax(const GovernorInput& input, const GovernorSettings& settings);
    GovernorDecision change(std::size_t quality_level, GovernorWhy why, base::Time now);
    [[nodiscard]] bool may_change(base::Time now, const GovernorSettings& settings) const;

    State now_, before_;  ///< before_: the state before the frame of now_.time was decided
};
static_assert(std::is_trivially_copyable_v<FrameGovernor>);

}  // namespace tedavis::effects
