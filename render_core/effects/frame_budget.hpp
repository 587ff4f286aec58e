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
#include "render_core/effects/renderer_choice.hpp"

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

/// What the decisions about a frame depend on of all earlier frames.
struct BudgetHistory {
    FrameGovernor governor;
    RendererChoice renderer;
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
    [[nodiscard]] bool is_reduced() const { return history_.governor.quality_level() > 0; }
    /// True where the last planned frame gives up the effect.
    [[nodiscard]] bool gives_up(Effect effect) const { return given_up_.has(effect) || level().given_up.has(effect); }

    /// Plans the frame. `counters` are those of this frame, whose terrain was selected with tau_factor() and whose glyphs with
    /// detail_factor().
    [[nodiscard]] FramePlan plan(PlanInput input, const DeviceCapability& device, const FrameCounters& counters,
                                 const TerrainTolerance& tolerance, base::Time now);
    [[nodiscard]] const BudgetReport& report() const { return report_; }
    /// Decides what draws the terrain of a frame of the design at place `design`. `counters`: of the frame by triangles, which
    /// were selected with tau_factor(); they are compared at the error that the design allows.
    RendererDecision choose_renderer(base::Time now, std::size_t design, const FrameCounters& counters,
                                     const TerrainTolerance& tolerance, TriangleFit fit);
    /// Replaces choose_renderer() in a frame without a choice.
    void rest_renderer(base::Time now) { history_.renderer.rest(now); }
    /// To be called when the design at a place is replaced by another one.
    void forget_renderer() { history_.renderer = RendererChoice(); }
    /// Whether it was measured what terrain by rays costs: choices between renderers then depend on earlier frames.
    [[nodiscard]] bool knows_rays() const { return costs_.knows_rays(); }

    /// Takes the measured time of the last planned frame, an upper bound; only where there is a clock, never in a replay.
    /// Modelled costs are then scaled to this machine, by 0.5 to 4. A time above the model but below the deadline may include
    /// waiting for the screen and is ignored.
    void record_measured(double ms);
    /// Draws all frames at one level, whatever they cost, until hold() is called; used to measure what a level costs and changes.
    void pin(const QualityLevel& level);
    /// Gives up further effects at every level; used to measure the cost of an effect.
    void give_up(const EffectSet& effects) { given_up_ = effects; }

    /// The history of decisions, to be saved and restored when frames are planned out of order.
    [[nodiscard]] const BudgetHistory& history() const { return history_; }
    void restore(const BudgetHistory& history) { history_ = history; }

private:
    [[nodiscard]] const QualityLevel& level() const { return levels_.at[history_.governor.quality_level()]; }
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
    BudgetHistory history_;
    BudgetReport report_;
};

}  // namespace tedavis::effects
