#include "host_sim/replay/cost_bench.hpp"

#include <algorithm>

#include "host_sim/measure/paired_cost.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/replay/quality_bench.hpp"
#include "render_core/display/calibration_subject.hpp"
#include "render_core/effects/design_effects.hpp"

namespace tedavis::host_sim {
namespace {

using effects::Effect;
using effects::Overhead;

constexpr double kTauFactors[] = {1, 1.6, 2.5, 4};  // of the terrain that is measured
constexpr const char* kGlyphDesign = "data/wind_arrows";
constexpr const char* kElementDesign = "default";  // with few glyphs, whose cost is taken off

/// Of effects that need more of a design than to be asked for.
struct CallingDesign {
    Effect effect;
    const char* design;
};
constexpr CallingDesign kCallingDesigns[] = {{Effect::surface_grid, "styles/line_texture"},
                                             {Effect::ridges, "styles/ridges_and_valleys"},
                                             {Effect::moving_sun, "styles/moving_sun"},
                                             {Effect::drape, "styles/aerial_image"},
                                             {Effect::ground_data, "data/ground_continuous"},
                                             {Effect::adjacent, "data/adjacent_uncertainty"},
                                             {Effect::vertical_lines, "effects/vertical_lines"},
                                             {Effect::projections, "effects/projections"},
                                             {Effect::curtains, "effects/curtains"},
                                             {Effect::soft_shadows, "effects/soft_shadows"},
                                             {Effect::volumetric_light, "effects/volumetric_light"},
                                             {Effect::focus_ground, "focus/brightness"},
                                             {Effect::focus_blur, "focus/blur"}};

bool can_be_switched(Effect effect) { return effects::row_of(effect).may_be_given_up; }

/// Everything that a design may be drawn without.
effects::EffectSet all_but_terrain() {
    effects::EffectSet all;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (static_cast<Effect>(n) != Effect::terrain) all.add(static_cast<Effect>(n));
    return all;
}

bool asks_for(const design::DesignSettings& design, Effect effect) {
    if (effect == Effect::ridges) return design.terrain.style.sketch.ridges > 0;
    if (effect == Effect::warning_colors) return design.warning_colors;
    return effects::asked_effects(design).has(effect);
}

/// Why an effect that was asked for did not run; empty: it did.
std::string why_not(const display::FrameRecord& record, Effect effect) {
    for (const display::EffectRecord& noted : record.effects)
        if (noted.name.view() == effects::row_of(effect).name && noted.state != display::EffectState::run)
            return std::string(noted.reason.view());
    return {};
}

}  // namespace

std::string design_calling_for(Effect effect) {
    for (const CallingDesign& calling : kCallingDesigns)
        if (calling.effect == effect) return calling.design;
    const bool is_free = effect == Effect::terrain || effects::row_of(effect).cost == "none";
    return is_free ? "" : "default";
}

PictureOptions CostBench::options_for(Effect effect) const {
    PictureOptions options = place_.picture;
    if (asks_for(load_design(options), effect)) return options;
    options.design = design_calling_for(effect);
    options.with.add(effect);
    return options;
}

/// The picture without anything beside terrain, at several tolerances and without any.
void CostBench::measure_terrain(MeasuredCosts& measured) {
    PictureOptions plain = place_.picture;
    plain.without = all_but_terrain();
    plain.scene.clear();
    std::vector<BenchSide> sides;
    const double tau_px = load_design(plain).terrain.tau_px;
    for (const double factor : kTauFactors) {
        plain.tau_px = tau_px * factor;
        sides.push_back(open_bench_side(place_, plain));
    }
    plain.terrain.clear();
    sides.push_back(open_bench_side(place_, plain));
    const std::vector<std::vector<double>> ms = bench_frames_ms(place_, sides, rounds_);
    width_px_ = sides.front().session->width();
    height_px_ = sides.front().session->height();
    measured.subject = display::calibration_subject(sides.front().session->display());
    std::vector<CostPoint> points;
    for (std::size_t n = 0; n + 1 < sides.size(); ++n)
        points.push_back({sides[n].session->display().planned().counters.triangles, median_of(ms[n])});
    const CostSlope slope = cost_slope(points);
    const double frame_ms = median_of(ms.back());
    MeasuredCost terrain{"terrain", {}, 0, 0, place_.picture.design, ""};
    terrain.line.ms_per_megapixel = std::max(slope.offset - frame_ms, 0.0) / megapixels();
    terrain.line.ms_per_thousand = slope.slope * 1000;
    const PairedCost whole = paired_cost(ms.front(), ms.back());
    terrain.ms = whole.ms;
    terrain.spread_ms = whole.spread_ms;
    measured.costs.push_back(terrain);
    costs_[Overhead::frame].fixed_ms = frame_ms;
    costs_[Effect::terrain] = terrain.line;
}

MeasuredCost CostBench::measure_effect(Effect effect) const {
    MeasuredCost cost;
    cost.name = effects::row_of(effect).name;
    if (design_calling_for(effect).empty()) return cost;
    PictureOptions options = options_for(effect);
    cost.design = options.design;
    std::vector<BenchSide> sides{open_bench_side(place_, options)};
    if (can_be_switched(effect)) {
        sides.push_back(sides.front());
        sides.back().given_up.add(effect);
    } else {
        options.without.add(effect);
        sides.push_back(open_bench_side(place_, options));
    }
    static_cast<void>(bench_frame_ms(place_, sides.front(), 0));
    display::Display& display = sides.front().session->display();
    cost.note = why_not(display.record(), effect);
    if (!cost.note.empty()) return cost;
    const double maps = display.planned().counters.maps;
    const std::vector<std::vector<double>> ms = bench_frames_ms(place_, sides, rounds_);
    const PairedCost paired = paired_cost(ms[0], ms[1]);
    cost.ms = paired.ms;
    cost.spread_ms = paired.spread_ms;
    if (thing_of(effect) == effects::CostThing::maps && maps > 0)
        cost.line.ms_per_thousand = paired.ms * 1000 / maps;
    else
        cost.line.ms_per_megapixel = paired.ms / megapixels();
    return cost;
}

/// Elements or glyphs of a design, against the same without a scene.
MeasuredCost CostBench::measure_overhead(Overhead overhead, const std::string& design) const {
    MeasuredCost cost;
    cost.name = effects::kOverheadNames[static_cast<std::size_t>(overhead)];
    cost.design = design;
    PictureOptions options = place_.picture;
    options.design = design;
    std::vector<BenchSide> sides{open_bench_side(place_, options)};
    options.scene.clear();
    sides.push_back(open_bench_side(place_, options));
    static_cast<void>(bench_frame_ms(place_, sides.front(), 0));
    const effects::FrameCounters counters = sides.front().session->display().planned().counters;
    const bool is_glyphs = overhead == Overhead::glyphs;
    const double things = is_glyphs ? counters.glyphs : counters.elements;
    if (!(things > 0)) {
        cost.note = is_glyphs ? "no field of glyphs is in view" : "no data are in view";
        return cost;
    }
    const std::vector<std::vector<double>> ms = bench_frames_ms(place_, sides, rounds_);
    const PairedCost paired = paired_cost(ms[0], ms[1]);
    const double of_glyphs_ms =
        is_glyphs || !(counters.glyphs > 0)
            ? 0
            : modelled_ms(costs_.overheads[static_cast<std::size_t>(Overhead::glyphs)], 0, counters.glyphs);
    cost.ms = std::max(paired.ms - of_glyphs_ms, 0.0);
    cost.spread_ms = paired.spread_ms;
    cost.line.ms_per_thousand = cost.ms * 1000 / things;
    return cost;
}

MeasuredCosts CostBench::measure(const std::function<void(std::size_t, std::size_t)>& progress) {
    constexpr std::size_t kTotal = effects::kEffectCount + effects::kOverheads - 1 + QualityBench::kPictures;
    MeasuredCosts measured;
    measured.rounds = rounds_;
    std::size_t done = 0;
    progress(done, kTotal);
    measure_terrain(measured);
    progress(++done, kTotal);
    for (std::size_t n = 1; n < effects::kEffectCount; ++n) {
        measured.costs.push_back(measure_effect(static_cast<Effect>(n)));
        progress(++done, kTotal);
    }
    const double frame_ms = costs_[Overhead::frame].fixed_ms;
    measured.costs.push_back({"frame", {frame_ms, 0, 0}, frame_ms, 0, place_.picture.design, ""});
    const MeasuredCost glyphs = measure_overhead(Overhead::glyphs, kGlyphDesign);
    costs_[Overhead::glyphs] = glyphs.line;
    progress(++done, kTotal);
    measured.costs.push_back(measure_overhead(Overhead::elements, kElementDesign));
    measured.costs.push_back(glyphs);
    progress(++done, kTotal);
    const QualityBench quality(place_, (rounds_ + 2) / 3);
    measured.candidates = quality.measure(measured.costs, [&] { progress(++done, kTotal); });
    return measured;
}

}  // namespace tedavis::host_sim
