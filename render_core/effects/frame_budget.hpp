/// Plans a display's frames within a deadline: models what each rung of the ladder would cost, lets the governor choose, and
/// plans with what that leaves. The terrain and the glyphs of a frame were chosen before; they follow with the next one.
///
///   hold(deadline, costs) once · tau_factor(), detail_factor() before, plan() after terrain and data are chosen, each frame
///
/// Without a deadline, or without known costs, it plans what is asked for and says why it rests.
/// Pure. Thread  one. Memory  none beside itself.
#pragma once

#include "render_core/effects/frame_governor.hpp"

namespace tedavis::effects {

/// What the design allows the terrain to miss, and beyond what it would be shown as degraded.
struct TerrainTolerance {
    double design_px = 1, coarse_px = 4;
};

struct BudgetReport {
    double deadline_ms = 0;   ///< 0: none is held
    double predicted_ms = 0;  ///< of the frame as planned, by the model; 0 where it is not known
    std::size_t rung = 0;
    bool changed = false;
    bool is_missed = false;  ///< dearer than the deadline all the same
    GovernorWhy why = GovernorWhy::no_deadline;
};

class FrameBudget {
public:
    /// `deadline_ms` 0: none.
    void hold(double deadline_ms, const CostTable& costs, const GovernorSettings& settings = {});
    [[nodiscard]] bool is_held() const { return deadline_ms_ > 0 && costs_.is_known; }

    /// Of the error that the design allows the terrain.
    [[nodiscard]] double tau_factor(const TerrainTolerance& tolerance) const;
    [[nodiscard]] double detail_factor() const { return kLadder[governor_.rung()].detail_factor; }
    [[nodiscard]] bool is_reduced() const { return governor_.rung() > 0; }
    /// As the frame that was planned last has it.
    [[nodiscard]] bool gives_up(Effect effect) const {
        return given_up_.has(effect) || given_up_on(governor_.rung()).has(effect);
    }

    /// `counters`: of this frame, whose terrain was chosen with tau_factor() and its glyphs with detail_factor().
    [[nodiscard]] FramePlan plan(PlanInput input, const DeviceCapability& device, const FrameCounters& counters,
                                 const TerrainTolerance& tolerance, base::Time now);
    [[nodiscard]] const BudgetReport& report() const { return report_; }

    /// What the frame that was planned last took at most, where somebody has a clock; never in a replay. Costs are scaled by what
    /// this machine needs now, between half and four times the model. Less than the deadline, but more than the model, may be
    /// waiting for the screen, and says nothing.
    void note_measured(double ms);
    /// On every rung, besides: what an effect costs is measured so.
    void give_up(const EffectSet& effects) { given_up_ = effects; }

    /// For who plans frames out of their order.
    [[nodiscard]] const FrameGovernor& governor() const { return governor_; }
    void restore(const FrameGovernor& governor) { governor_ = governor; }

private:
    [[nodiscard]] std::array<double, kRungs> costs_of_rungs(const PlanInput& input, const DeviceCapability& device,
                                                            const FrameCounters& counters,
                                                            const TerrainTolerance& tolerance) const;

    double deadline_ms_ = 0;
    double measured_factor_ = 1;
    CostTable costs_;
    EffectSet given_up_;
    GovernorSettings settings_;
    FrameGovernor governor_;
    BudgetReport report_;
};

}  // namespace tedavis::effects
