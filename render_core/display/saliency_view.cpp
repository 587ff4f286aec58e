#include "render_core/display/saliency_view.hpp"

#include "render_core/draw/data/label_planner.hpp"
#include "render_core/flight/decision_interval.hpp"

namespace tedavis::display {
using draw::LabelPlanner;

base::Error SaliencyView::start(gl::Gl& gl, base::BudgetTable& budget, draw::DrawnDesigns designs, std::uint32_t width_px,
                                std::uint32_t height_px) {
    bool shows_map = false, shows_heat = false;
    for (const draw::DrawnDesign& drawn : designs) {
        shows_map = shows_map || drawn.design->effects.saliency.view == design::SaliencyView::map;
        shows_heat = shows_heat || drawn.design->effects.saliency.view == design::SaliencyView::heat;
    }
    keeps_ = gl.device().lane == effects::Lane::es2;
    if (!shows_map && !shows_heat) return {};
    return pass_.start(gl, budget, width_px, height_px, shows_map, shows_heat);
}

bool SaliencyView::shows(const design::Saliency& saliency) const { return pass_.can_show(saliency.view); }

void SaliencyView::plan(bool runs, base::Time now) {
    runs_ = runs && pass_.is_started();
    now_ = now;
    measures_ = runs_ && (!keeps_ || !has_map_ || now == measured_ ||
                          flight::decision_interval_of(now) != flight::decision_interval_of(measured_));
}

base::Time SaliencyView::needed_since(base::Time time) const {
    if (!keeps_ || !pass_.is_started()) return time;
    return base::Time{flight::decision_interval_of(time) * flight::kDecisionInterval.ns};
}

void SaliencyView::draw(gl::Gl& gl, const base::Surface& surface, const design::Saliency& saliency, EffectWork& work) {
    if (!runs_) return;
    const WorkScope scope(gl, work, measures_ ? 2 : 1);
    if (measures_) {
        pass_.measure(gl, surface, saliency.scale);
        measured_ = now_;
        has_map_ = true;
    }
    pass_.show(gl, saliency.view);
}

}  // namespace tedavis::display
