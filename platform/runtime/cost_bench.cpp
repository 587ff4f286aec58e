#include "platform/runtime/cost_bench.hpp"

#include <algorithm>

#include "platform/runtime/quality_bench.hpp"
#include "render_core/display/calibration_subject.hpp"
#include "render_core/effects/design_effects.hpp"

namespace tedavis::platform {
namespace {

using effects::CostPoint;
using effects::Effect;
using effects::MeasuredCost;
using effects::MeasuredCosts;
using effects::Overhead;

constexpr double kTauFactors[] = {1, 1.6, 2.5, 4};  // of the terrain that is measured
constexpr std::uint32_t kRoundsOfEffect = 3;        // for one of a quality level

bool can_be_switched(Effect effect) { return effects::row_of(effect).may_be_given_up; }
bool is_measured_otherwise(Effect effect) { return effect == Effect::terrain || effects::row_of(effect).cost == "none"; }

/// Everything that a design may be drawn without.
void take_out_all_but_terrain(design::DesignSettings& design) {
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (static_cast<Effect>(n) != Effect::terrain) design = effects::without_effect(design, static_cast<Effect>(n));
}

/// Why an effect that was asked for did not run; empty: it did.
std::string_view why_not(const display::FrameRecord& record, Effect effect) {
    for (const display::EffectRecord& noted : record.effects)
        if (noted.name.view() == effects::row_of(effect).name && noted.state != display::EffectState::run)
            return noted.reason.view();
    return {};
}

}  // namespace

bool asks_for(const design::DesignSettings& design, Effect effect) noexcept {
    if (effect == Effect::ridges) return design.terrain.style.sketch.ridges > 0;
    if (effect == Effect::warning_colors) return design.warning_colors;
    return effects::asked_effects(design).has(effect);
}

/// Of the own picture only the terrain remains.
void CostBench::take_bare_picture() {
    displays_.own_picture(picture_);
    picture_.has_scene = false;
    take_out_all_but_terrain(picture_.design);
    picture_.design.terrain.renderer = design::TerrainRenderer::raster;
}

/// The terrain at several tolerances, and the picture without it.
base::Error CostBench::open_terrain_sides() {
    take_bare_picture();
    const double tau_px = picture_.design.terrain.tau_px;
    frames_.close();
    for (const double factor : kTauFactors) {
        picture_.design.terrain.tau_px = tau_px * factor;
        if (base::Error error = frames_.open(picture_)) return error;
    }
    picture_.has_terrain = false;
    return frames_.open(picture_);
}

base::Error CostBench::measure_terrain(MeasuredCosts& measured) {
    if (base::Error error = open_terrain_sides()) return error;
    if (!frames_.take_times(rounds_)) return frames_.fault();
    width_px_ = frames_.surface(0).width();
    height_px_ = frames_.surface(0).height();
    measured.subject = display::calibration_subject(frames_.display(0));
    const std::size_t without = frames_.sides() - 1;
    std::array<CostPoint, std::size(kTauFactors)> points;
    for (std::size_t n = 0; n < without; ++n) points[n] = {frames_.display(n).planned().counters.triangles, frames_.median_ms(n)};
    if (!(points[0].things > 0))
        return base::make_error("no terrain is in view where costs are measured; measure over a place that the terrain has");
    const effects::CostSlope slope = effects::cost_slope({points.data(), points.size()});
    const double frame_ms = frames_.median_ms(without);
    const effects::PairedCost whole = frames_.cost_between(0, without);
    MeasuredCost terrain;
    terrain.name = effects::row_of(Effect::terrain).name;
    terrain.line.ms_per_megapixel = std::max(slope.offset - frame_ms, 0.0) / megapixels();
    terrain.line.ms_per_thousand = slope.slope * 1000;
    terrain.ms = whole.ms;
    terrain.spread_ms = whole.spread_ms;
    terrain.design = picture_.name;
    static_cast<void>(measured.costs.try_push_back(terrain));
    costs_[Overhead::frame].fixed_ms = frame_ms;
    costs_[Effect::terrain] = terrain.line;
    return {};
}

/// Side 0 with the effect, side 1 without.
base::Error CostBench::open_effect_sides(Effect effect) {
    frames_.close();
    if (base::Error error = frames_.open(picture_)) return error;
    if (!can_be_switched(effect)) {
        picture_.design = effects::without_effect(picture_.design, effect);
        return frames_.open(picture_);
    }
    effects::EffectSet given_up;
    given_up.add(effect);
    frames_.share(given_up);
    return {};
}

void CostBench::measure_effect(Effect effect, MeasuredCost& cost) {
    cost.name = effects::row_of(effect).name;
    if (is_measured_otherwise(effect)) return;
    cost.note = displays_.picture_with(effect, picture_);
    if (!cost.note.empty()) return;
    cost.design = picture_.name;
    if (const base::Error error = open_effect_sides(effect)) {
        cost.note = error.message.view();
        return;
    }
    double ms = 0;
    if (!frames_.draw(0, 0, ms)) return;
    cost.note = why_not(frames_.display(0).record(), effect);
    const double maps = frames_.display(0).planned().counters.maps;
    if (!cost.note.empty() || !frames_.take_times(rounds_)) return;
    const effects::PairedCost paired = frames_.cost_between(0, 1);
    cost.ms = paired.ms;
    cost.spread_ms = paired.spread_ms;
    if (thing_of(effect) == effects::CostThing::maps && maps > 0)
        cost.line.ms_per_thousand = paired.ms * 1000 / maps;
    else
        cost.line.ms_per_megapixel = paired.ms / megapixels();
}

base::Error CostBench::measure_effects(MeasuredCosts& measured) {
    for (std::size_t n = 1; n < effects::kEffectCount; ++n) {
        MeasuredCost cost;
        measure_effect(static_cast<Effect>(n), cost);
        if (frames_.fault()) return frames_.fault();
        static_cast<void>(measured.costs.try_push_back(cost));
        step(done_);
    }
    return {};
}

/// Elements or glyphs of a design, against the same without a scene.
void CostBench::measure_overhead(Overhead overhead, MeasuredCost& cost) {
    cost.name = effects::kOverheadNames[static_cast<std::size_t>(overhead)];
    cost.note = displays_.picture_with(overhead, picture_);
    if (!cost.note.empty()) return;
    cost.design = picture_.name;
    frames_.close();
    base::Error error = frames_.open(picture_);
    picture_.has_scene = false;
    if (!error) error = frames_.open(picture_);
    cost.note = error.message.view();
    double ms = 0;
    if (error || !frames_.draw(0, 0, ms)) return;
    const effects::FrameCounters counters = frames_.display(0).planned().counters;
    const bool is_glyphs = overhead == Overhead::glyphs;
    const double things = is_glyphs ? counters.glyphs : counters.elements;
    if (!(things > 0)) cost.note = is_glyphs ? "no field of glyphs is in view" : "no data are in view";
    if (!(things > 0) || !frames_.take_times(rounds_)) return;
    const effects::PairedCost paired = frames_.cost_between(0, 1);
    const double glyphs_ms = is_glyphs ? 0 : modelled_ms(costs_[Overhead::glyphs], 0, counters.glyphs);
    cost.ms = std::max(paired.ms - glyphs_ms, 0.0);
    cost.spread_ms = paired.spread_ms;
    cost.line.ms_per_thousand = cost.ms * 1000 / things;
}

/// Terrain by rays, against the picture without terrain.
void CostBench::measure_rays(MeasuredCost& cost) {
    cost.name = effects::kOverheadNames[static_cast<std::size_t>(Overhead::rays)];
    take_bare_picture();
    picture_.design.terrain.renderer = design::TerrainRenderer::trace;
    frames_.close();
    base::Error error = frames_.open(picture_);
    picture_.has_terrain = false;
    if (!error) error = frames_.open(picture_);
    cost.note = error.message.view();
    double ms = 0;
    if (error || !frames_.draw(0, 0, ms)) return;
    cost.note = frames_.display(0).record().terrain.renderer_reason.view();
    if (!cost.note.empty() || !frames_.take_times(rounds_)) return;
    const effects::PairedCost paired = frames_.cost_between(0, 1);
    cost.design = picture_.name;
    cost.ms = paired.ms;
    cost.spread_ms = paired.spread_ms;
    cost.line.ms_per_megapixel = paired.ms / megapixels();
}

base::Error CostBench::measure_overheads(MeasuredCosts& measured) {
    const double frame_ms = costs_[Overhead::frame].fixed_ms;
    MeasuredCost frame, glyphs, elements, rays;
    frame.name = effects::kOverheadNames[static_cast<std::size_t>(Overhead::frame)];
    frame.line.fixed_ms = frame.ms = frame_ms;
    frame.design = measured.costs[0].design;
    measure_overhead(Overhead::glyphs, glyphs);
    costs_[Overhead::glyphs] = glyphs.line;
    step(done_);
    measure_overhead(Overhead::elements, elements);
    step(done_);
    measure_rays(rays);
    step(done_);
    for (const MeasuredCost* const cost : {&frame, &elements, &glyphs, &rays})
        static_cast<void>(measured.costs.try_push_back(*cost));
    return frames_.fault();
}

base::Error CostBench::measure(MeasuredCosts& measured) {
    measured.rounds = rounds_;
    displays_.progress(0, total());
    if (base::Error error = measure_terrain(measured)) return error;
    step(done_);
    if (base::Error error = measure_effects(measured)) return error;
    if (base::Error error = measure_overheads(measured)) return error;
    frames_.close();
    QualityBench quality(displays_, frames_, (rounds_ + kRoundsOfEffect - 1) / kRoundsOfEffect);
    return quality.measure({measured.costs.data(), measured.costs.size()}, measured.candidates, done_, total());
}

}  // namespace tedavis::platform
