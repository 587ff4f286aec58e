#include "render_core/effects/frame_budget.hpp"

#include <cmath>

namespace tedavis::effects {
namespace {

constexpr double kMinFactor = 0.5, kMaxFactor = 4;
constexpr double kMeasuredWeight = 1.0 / 16;  // of one frame: a single late one is no trend

Quality quality_on(const QualityLevel& level, const TerrainTolerance& tolerance) {
    return {tau_px_on(level, tolerance.design_px, tolerance.coarse_px), level.detail_factor};
}

}  // namespace

void FrameBudget::hold(double deadline_ms, const CostTable& costs, const QualityLevels& levels,
                       const GovernorSettings& settings) {
    deadline_ms_ = deadline_ms;
    costs_ = costs;
    levels_ = levels;
    settings_ = settings;
    measured_factor_ = 1;
    history_ = BudgetHistory();
}

void FrameBudget::pin(const QualityLevel& level) {
    hold(0, costs_);
    levels_.at[0] = level;
}

double FrameBudget::tau_factor(const TerrainTolerance& tolerance) const {
    return tau_px_on(level(), tolerance.design_px, tolerance.coarse_px) / tolerance.design_px;
}

std::array<double, kQualityLevelCount> FrameBudget::costs_of_quality_levels(const PlanInput& input,
                                                                            const DeviceCapability& device,
                                                                            const FrameCounters& counters,
                                                                            const TerrainTolerance& tolerance) const {
    const Quality now = quality_on(level(), tolerance);
    std::array<double, kQualityLevelCount> ms{};
    for (std::size_t quality_level = 0; quality_level < levels_.count; ++quality_level) {
        PlanInput on_quality_level = input;
        on_quality_level.too_costly.add(levels_.at[quality_level].given_up);
        const FrameCounters there = counters_at(counters, now, quality_on(levels_.at[quality_level], tolerance));
        ms[quality_level] = measured_factor_ * modelled_ms(costs_, plan_effects(on_quality_level, device), there);
    }
    return ms;
}

FramePlan FrameBudget::plan(PlanInput input, const DeviceCapability& device, const FrameCounters& counters,
                            const TerrainTolerance& tolerance, base::Time now) {
    report_ = {};
    report_.deadline_ms = deadline_ms_;
    input.too_costly.add(given_up_);
    if (is_held()) {
        const GovernorDecision decision = history_.governor.decide(
            {now, deadline_ms_, costs_of_quality_levels(input, device, counters, tolerance), levels_.count}, settings_);
        report_.quality_level = decision.quality_level;
        report_.changed = decision.changed;
        report_.why = decision.why;
    } else if (deadline_ms_ > 0) {
        report_.why = GovernorWhy::cost_unknown;
    }
    report_.quality = level();
    input.too_costly.add(level().given_up);
    FramePlan plan = plan_effects(input, device);
    if (costs_.is_known) report_.predicted_ms = measured_factor_ * modelled_ms(costs_, plan, counters);
    report_.is_missed = is_held() && report_.predicted_ms > deadline_ms_;
    return plan;
}

/// Measured times of frames scale both costs alike and are left out, so that a replay of a live flight chooses as the flight did.
RendererDecision FrameBudget::choose_renderer(base::Time now, std::size_t design, const FrameCounters& counters,
                                              const TerrainTolerance& tolerance, TriangleFit fit) {
    RendererCosts costs;
    if (costs_.knows_rays()) {
        FrameCounters of_design = counters_at(counters, quality_on(level(), tolerance), {tolerance.design_px, 1});
        costs = {true, terrain_ms(costs_, of_design), 0, modelled_ms(costs_[Overhead::frame], counters.megapixels, 0),
                 deadline_ms_};
        of_design.is_traced = true;
        costs.rays_ms = terrain_ms(costs_, of_design);
    }
    return history_.renderer.decide(now, design, costs, fit);
}

void FrameBudget::record_measured(double ms) {
    if (!(report_.predicted_ms > 0) || !(ms > 0)) return;
    if (ms > report_.predicted_ms && ms <= deadline_ms_) return;
    const double factor = measured_factor_ * ms / report_.predicted_ms;
    measured_factor_ += kMeasuredWeight * (std::fmin(std::fmax(factor, kMinFactor), kMaxFactor) - measured_factor_);
}

}  // namespace tedavis::effects
