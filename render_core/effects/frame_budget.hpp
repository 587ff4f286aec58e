/// Plans a display's frames within a deadline: models the cost of each quality level, lets the governor choose a level, and
/// plans the effects of that level. Terrain and glyphs of the frame were selected before; they follow in the next frame.
///
///   hold(deadline, costs, levels) once · tau_factor(), detail_factor() before, plan() after terrain and data are chosen, each
///   frame
///
/// Without a deadline or without known costs it plans the requested effects and states why nothing is reduced.
/// Pure. Thread  one. Memory  none besides itself.
#pragma once

#include "render_core/effects/frame_governor.hpp"

namespace tedavis::effects {

/// The terrain's pixel error that the design allows, and the one beyond which it is shown as degraded.
struct TerrainTolerance {
    double design_px = 1, coarse_px = 4;
};

struct BudgetReport {
    double deadline_ms = 0;   ///< 0: none is held
    double predicted_ms = 0;  ///< modelled cost of the planned frame; 0 where it is unknown
    std::size_t quality_level = 0;
    bool changed = false;
    bool is_missed = false;  ///< the modelled cost exceeds the deadline nevertheless
    GovernorWhy why = GovernorWhy::no_deadline;
    QualityLevel quality;  ///< of the level
};

class FrameBudget {
public:
    /// Sets the deadline, the costs and the levels to choose from, which fault_of() finds nothing wrong with; `deadline_ms` 0
    /// means none.
    void hold(double deadline_ms, const CostTable& costs, const QualityLevels& levels = {},
              const GovernorSettings& settings = {});
    [[nodiscard]] bool is_held() const { return deadline_ms_ > 0 && costs_.is_known; }

    /// Factor for the error that the design allows the terrain.
    [[nodiscard]] double tau_factor(const TerrainTolerance& tolerance) const;
    [[nodiscard]] double detail_factor() const { return level().detail_factor; }
    [[nodiscard]] bool is_reduced() const { return governor_.quality_level() > 0; }
    /// True where the last planned frame gives up the effect.
    [[nodiscard]] bool gives_up(Effect effect) const { return given_up_.has(effect) || level().given_up.has(effect); }

    /// Plans the frame. `counters` are those of this frame, whose terrain was selected with tau_factor() and whose glyphs with
    /// detail_factor().
    [[nodiscard]] FramePlan plan(PlanInput input, const DeviceCapability& device, const FrameCounters& counters,
                                 const TerrainTolerance& tolerance, base::Time now);
    [[nodiscard]] const BudgetReport& report() const { return report_; }

    /// Takes the measured time of the last planned frame, an upper bound; only where there is a clock, never in a replay.
    /// Modelled costs are then scaled to this machine, by 0.5 to 4. A time above the model but below the deadline may include
    /// waiting for the screen and is ignored.
    void record_measured(double ms);
    /// Draws all frames at one level, whatever they cost, until hold() is called; used to measure what a level costs and changes.
    void pin(const QualityLevel& level);
    /// Gives up further effects at every level; used to measure the cost of an effect.
    void give_up(const EffectSet& effects) { given_up_ = effects; }

    /// For planning frames out of order.
    [[nodiscard]] const FrameGovernor& governor() const { return governor_; }
    void restore(const FrameGovernor& governor) { governor_ = governor; }

private:
    [[nodiscard]] const QualityLevel& level() const { return levels_.at[governor_.quality_level()]; }
    [[nodiscard]] std::array<double, kQualityLevelCount> costs_of_quality_levels(const PlanInput& input,
                                                                                 const DeviceCapability& device,
                                                                                 const FrameCounters& counters,
                                                                                 const TerrainTolerance& tolerance) const;

    double deadline_ms_ = 0;
    double measured_factor_ = 1;
    CostTable costs_;
    QualityLevels levels_;
    EffectSet given_up_;
    GovernorSettings settings_;
    FrameGovernor governor_;
    BudgetReport report_;
};

}  // namespace tedavis::effects
