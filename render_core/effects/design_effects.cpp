#include "render_core/effects/design_effects.hpp"

#include <algorithm>
#include <iterator>

namespace tedavis::effects {
namespace {

/// Ground without shades and without lines would say nothing.
void give_lines(design::SketchSettings& sketch) {
    constexpr double kStrength = 0.5;
    const double lines[] = {sketch.silhouettes, sketch.ridges,   sketch.valleys,  sketch.suggestive_contours,
                            sketch.contours,    sketch.hatching, sketch.stippling};
    if (*std::max_element(std::begin(lines), std::end(lines)) <= 0) sketch.contours = kStrength;
}

void replace(const EffectRow& row, const design::DesignSettings& asked, Effect by, design::DesignSettings& possible) {
    if (row.replace != nullptr)
        row.replace(asked, by, possible);
    else if (row.take_out != nullptr && by != row.effect)
        row.take_out(possible);
}

}  // namespace

design::DesignSettings design_on(const DeviceSettings& device, const design::DesignSettings& design) noexcept {
    using design::Antialiasing;
    design::DesignSettings decided = design;
    Antialiasing& antialiasing = decided.effects.antialiasing;
    if (antialiasing == Antialiasing::by_device)
        antialiasing = device.affords_antialiasing ? Antialiasing::on : Antialiasing::off;
    return decided;
}

EffectSet asked_effects(const design::DesignSettings& design) noexcept {
    EffectSet asked;
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectRow& row = row_of(static_cast<Effect>(n));
        if (row.is_asked != nullptr && row.is_asked(design)) asked.add(row.effect);
    }
    return asked;
}

design::DesignSettings with_effect(const design::DesignSettings& design, Effect effect) noexcept {
    design::DesignSettings with = design;
    if (row_of(effect).ask != nullptr) row_of(effect).ask(with);
    return with;
}

design::DesignSettings without_effect(const design::DesignSettings& design, Effect effect) noexcept {
    design::DesignSettings without = design;
    if (row_of(effect).take_out != nullptr) row_of(effect).take_out(without);
    return without;
}

bool reads_distances(const design::DesignSettings& design) noexcept {
    return design.terrain.style.sketch.silhouettes > 0 || design.effects.depth_of_field.blur_px > 0 ||
           design.effects.shadows.in_air > 0;
}

EffectSet effects_in_reserve(const design::DesignSettings& possible) noexcept {
    EffectSet reserve;
    if (possible.terrain.style.sketch.ridges > 0) reserve.add(Effect::ridges);
    if (design::change_the_ground(possible.foci)) reserve.add(Effect::focus_ground);
    reserve.add(Effect::fixed_light);
    return reserve;
}

ReplacementOrder order_of(const design::DesignSettings& design) noexcept {
    const auto order = replacement_order(design.effects.instead);
    return order.ok() ? order.value() : ReplacementOrder();
}

/// In the table's order: what takes a place stands before what it takes the place of, unless a row's own replace() asks no more.
design::DesignSettings possible_design(const design::DesignSettings& design, const DeviceSettings& device) {
    const ReplacementOrder order = order_of(design);
    design::DesignSettings possible = design_on(device, design);
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectRow& row = row_of(static_cast<Effect>(n));
        replace(row, design, possible_effect(row.effect, device.forbidden, device.capability, order), possible);
    }
    if (terrain_of_context(possible.foci).sketch_outside) give_lines(possible.terrain.style.sketch);
    if (possible.sky.air.is_shown) possible.sky.haze_distance_m = 0;
    return possible;
}

}  // namespace tedavis::effects
