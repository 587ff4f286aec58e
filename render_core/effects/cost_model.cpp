#include "render_core/effects/cost_model.hpp"

namespace tedavis::effects {
namespace {

double count_of(CostThing thing, const FrameCounters& counters) {
    return thing == CostThing::triangles ? counters.triangles : thing == CostThing::maps ? counters.maps : 0;
}

double count_of(Overhead overhead, const FrameCounters& counters) {
    return overhead == Overhead::elements ? counters.elements : overhead == Overhead::glyphs ? counters.glyphs : 0;
}

/// Elements and glyphs cost nothing in frames that have none. Rays are counted as terrain.
bool is_there(Overhead overhead, const FrameCounters& counters) {
    return overhead == Overhead::frame || count_of(overhead, counters) > 0;
}

double effect_ms(const CostTable& table, Effect effect, const FrameCounters& counters) {
    if (effect == Effect::terrain) return terrain_ms(table, counters);
    return modelled_ms(table[effect], counters.megapixels, count_of(thing_of(effect), counters));
}

}  // namespace

CostThing thing_of(Effect effect) noexcept {
    return effect == Effect::terrain ? CostThing::triangles : effect == Effect::adjacent ? CostThing::maps : CostThing::none;
}

double modelled_ms(const CostLine& line, double megapixels, double things) noexcept {
    return line.fixed_ms + line.ms_per_megapixel * megapixels + line.ms_per_thousand * things / 1000;
}

double terrain_ms(const CostTable& table, const FrameCounters& counters) noexcept {
    if (counters.is_traced && table.knows_rays()) return modelled_ms(table[Overhead::rays], counters.megapixels, 0);
    return modelled_ms(table[Effect::terrain], counters.megapixels, counters.triangles);
}

double modelled_ms(const CostTable& table, const FramePlan& plan, const FrameCounters& counters) noexcept {
    double sum_ms = 0;
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        if (plan.runs(effect)) sum_ms += effect_ms(table, effect, counters);
    }
    for (std::size_t n = 0; n < kOverheads; ++n) {
        const auto overhead = static_cast<Overhead>(n);
        if (is_there(overhead, counters))
            sum_ms += modelled_ms(table.overheads[n], counters.megapixels, count_of(overhead, counters));
    }
    return sum_ms;
}

}  // namespace tedavis::effects
