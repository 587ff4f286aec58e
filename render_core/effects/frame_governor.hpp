/// Holds a frame's deadline by choosing a rung of quality_ladder.hpp. Deterministic: it knows the source's time and modelled
/// costs and reads no clock, so that a replay decides what the flight did.
///
/// - A frame that is modelled dearer than `act_at` of the deadline goes at once to the richest rung below `aim_at` of it, not
/// rung
///   by rung; costs that grow steadily are taken for what they will be when the next change is due.
/// - A richer rung comes back when it has been below `relax_at` for the time of the dwell without a break; after a return that
/// did not
///   last the wait is doubled, up to `most_patience` times the dwell.
/// - Between two changes the dwell passes. A frame that is too dear meanwhile says so, as does one on the last rung.
///
/// Pure. Thread  any. Memory  none; the state is plain data of fixed size.
#pragma once

#include <string_view>

#include "render_core/base/time.hpp"
#include "render_core/effects/quality_ladder.hpp"

namespace tedavis::effects {

struct GovernorSettings {
    base::Duration dwell = base::Duration::seconds(2);
    double act_at = 0.95, aim_at = 0.85, relax_at = 0.75;  ///< of the deadline
    std::uint32_t most_patience = 16;
};

enum class GovernorWhy : std::uint8_t {
    no_deadline,
    cost_unknown,     ///< no calibration: it rests
    fits,             ///< the design's own picture
    too_dear,         ///< changed to a cheaper rung in this frame
    cheaper_for_now,  ///< a richer rung would be too dear, or has not been cheap enough for long enough
    relaxed,          ///< changed to a richer rung in this frame
    waits,            ///< too dear, but the last change was less than the dwell ago
    cheapest_is_too_dear,
    count_
};
/// For records and reports.
[[nodiscard]] std::string_view to_string(GovernorWhy why) noexcept;

struct GovernorInput {
    base::Time now;  ///< the source's; earlier than the last one begins anew, the same one decides the same frame again
    double deadline_ms = 0;
    std::array<double, kRungs> ms{};  ///< modelled cost of this frame on every rung, falling
};

struct GovernorDecision {
    std::size_t rung = 0;
    bool changed = false;
    GovernorWhy why = GovernorWhy::no_deadline;
};

/// How fast a cost grows, in spite of jumps: the median of the last steps.
class CostTrend {
public:
    void take(base::Time now, double ms);
    /// At least 1: by how much the cost will have grown after `ahead`.
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
    /// That has decided for `rung` and knows nothing else.
    explicit FrameGovernor(std::size_t rung) { now_.rung = static_cast<std::uint8_t>(rung); }
    /// Once a frame. The deadline is above 0.
    GovernorDecision decide(const GovernorInput& input, const GovernorSettings& settings = {});
    /// Of the last decision.
    [[nodiscard]] std::size_t rung() const { return now_.rung; }

private:
    struct State {
        bool has_begun = false, has_changed = false, has_relaxed = false;
        std::uint8_t rung = 0;
        std::uint32_t patience = 1;  ///< dwells for which a richer rung must have been cheap enough
        base::Time time, last_change, last_relaxed;
        std::array<base::Time, kRungs> cheap_since{};  ///< of richer rungs
        CostTrend trend;
    };
    void begin(const GovernorInput& input);
    void note_cheap_rungs(const GovernorInput& input, const GovernorSettings& settings, double growth);
    GovernorDecision tighten(const GovernorInput& input, const GovernorSettings& settings, double growth);
    GovernorDecision relax(const GovernorInput& input, const GovernorSettings& settings);
    GovernorDecision change(std::size_t rung, GovernorWhy why, base::Time now);
    [[nodiscard]] bool may_change(base::Time now, const GovernorSettings& settings) const;

    State now_, before_;  ///< before_: when the frame of now_.time had not been decided yet
};
static_assert(std::is_trivially_copyable_v<FrameGovernor>);

}  // namespace tedavis::effects
