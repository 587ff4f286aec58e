#include "render_core/design/weighted_design.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/design/color_difference.hpp"

namespace tedavis::design {
namespace {

constexpr double kWhollyReadable = 0.5;  ///< of the shading that is left where continuous colours must be read
constexpr double kMinIntrinsic = 0.25;   ///< two gradations
constexpr double kUnseen = 1.0 / 1024;   ///< of a strength: less than a step of a colour

constexpr double SketchSettings::*kLines[] = {
    &SketchSettings::silhouettes, &SketchSettings::ridges,   &SketchSettings::valleys,  &SketchSettings::suggestive_contours,
    &SketchSettings::contours,    &SketchSettings::hatching, &SketchSettings::stippling};

Color darker(Color color, double light) { return blended({0, 0, 0, color.alpha}, color, light); }

double least_difference(const DataScale& scale, double light) {
    double least = 1e9;
    for (std::size_t n = 0; n < scale.breaks.size(); ++n) {
        const Lab a = lab_of(linear_rgb(darker(color_of_class(scale, n), light)));
        const Lab b = lab_of(linear_rgb(darker(color_of_class(scale, n + 1), light)));
        least = std::fmin(least, color_difference(a, b));
    }
    return least;
}

bool is_extrinsic(ElementUncertainty technique) {
    return technique == ElementUncertainty::ellipsoid || technique == ElementUncertainty::circles ||
           technique == ElementUncertainty::triangles || technique == ElementUncertainty::tetrahedra;
}

struct Details {
    double intrinsic, extrinsic;
};

Details uncertainty_details(const PrioritySettings& priority, const AspectWeights& weights) {
    const double terrain = weights.of[kTerrainAspect], unsure = weights.of[kUncertaintyAspect];
    const double room = terrain > unsure ? 1 - terrain : 1;
    return {std::fmax(priority.intrinsic.at(unsure), kMinIntrinsic), std::fmin(priority.extrinsic.at(unsure), room)};
}

void apply_to_element(const PrioritySettings& priority, const AspectWeights& weights, const Details& details,
                      DataElement& element) {
    const double weight = weights.of[priority.aspect_of(element.role)];
    const bool shows_uncertainty = element.technique == DataTechnique::uncertainty_only;
    element.detail *= shows_uncertainty ? details.extrinsic : priority.data.at(weight);
    if (element.uncertainty == ElementUncertainty::none) return;
    if (is_extrinsic(element.uncertainty) && levels_at_detail(element.uncertainty_levels, details.extrinsic) == 1)
        element.uncertainty =
            element.technique == DataTechnique::billboard ? ElementUncertainty::dashed_rim : ElementUncertainty::transparency;
    const double detail = is_extrinsic(element.uncertainty) ? details.extrinsic : details.intrinsic;
    element.uncertainty_levels = levels_at_detail(element.uncertainty_levels, detail);
}

/// Glyphs that say nothing but how unsure data are go with the room for them.
void apply_to_elements(const PrioritySettings& priority, const AspectWeights& weights, const Details& details,
                       DataElementList& elements) {
    std::size_t kept = 0;
    for (std::size_t n = 0; n < elements.size(); ++n) {
        apply_to_element(priority, weights, details, elements[n]);
        const bool is_left =
            elements[n].technique != DataTechnique::uncertainty_only || levels_at_detail(0, details.extrinsic) != 1;
        if (is_left && kept != n) elements[kept] = elements[n];
        kept += is_left ? 1 : 0;
    }
    elements.truncate(kept);
}

/// Where data come before terrain their colours must be read as they are.
double readable_shading(const GroundData& ground, const AspectWeights& weights) {
    if (!ground.is_shown || weights.of[kDataAspect] <= weights.of[kTerrainAspect]) return 1;
    return 1 - (1 - kWhollyReadable) * detail_of(ground.scale);
}

}  // namespace

ShadeSettings at_strength(const ShadeSettings& shade, double strength) noexcept {
    ShadeSettings weaker = shade;
    // These two have no light of their own to add to.
    const bool is_whole = shade.technique == TerrainShade::light_map || shade.technique == TerrainShade::aperture;
    const double kept = is_whole ? std::floor(strength + 0.5) : strength;
    weaker.ambient_occlusion *= strength;
    weaker.openness *= strength;
    weaker.highlight *= strength;
    weaker.ambient = 1 - (1 - shade.ambient) * kept;
    weaker.ambient_color = blended({0xFF, 0xFF, 0xFF, shade.ambient_color.alpha}, shade.ambient_color, kept);
    if (kept > 0) return weaker;
    weaker.technique = TerrainShade::none;
    weaker.ambient = shade.ambient;
    weaker.ambient_color = shade.ambient_color;
    weaker.cast_shadows = false;
    return weaker;
}

SketchSettings at_strength(const SketchSettings& sketch, double strength) noexcept {
    SketchSettings weaker = sketch;
    for (double SketchSettings::*const line : kLines) weaker.*line *= strength;
    return weaker;
}

double legible_ambient(const ShadeSettings& shade, const DataScale& scale, double least) noexcept {
    if (scale.breaks.empty() || least_difference(scale, shade.ambient) >= least) return shade.ambient;
    if (least_difference(scale, 1) < least) return 1;
    double dark = shade.ambient, light = 1;
    for (int n = 0; n < 12; ++n) {
        const double middle = 0.5 * (dark + light);
        (least_difference(scale, middle) >= least ? light : dark) = middle;
    }
    return light;
}

void apply_priorities(const AspectWeights& weights, DesignSettings& design) noexcept {
    const PrioritySettings& priority = design.priority;
    if (!priority.is_stated) return;
    const double terrain = weights.of[kTerrainAspect], data = priority.data.at(weights.of[kDataAspect]);
    const Details details = uncertainty_details(priority, weights);
    // Where nothing else says how unsure the ground's colours are.
    const bool has_overlay_alone = design.data.ground.uncertainty.technique == IntrinsicUncertainty::none;
    const double overlay = has_overlay_alone ? std::fmax(details.extrinsic, kMinIntrinsic) : details.extrinsic;
    design.data.ground = at_detail(design.data.ground, {data, details.intrinsic, overlay});
    if (design.data.ground.overlay.strength <= 0) design.data.ground.overlay.technique = UncertaintyOverlay::none;
    apply_to_elements(priority, weights, details, design.data.elements);
    TerrainStyle& style = design.terrain.style;
    const double shading = std::fmin(priority.shading.at(terrain), readable_shading(design.data.ground, weights));
    style.shade = at_strength(style.shade, shading);
    style.sketch = at_strength(style.sketch, priority.sketch.knots.empty() ? 1 : priority.sketch.at(terrain));
    if (design.data.ground.is_shown && style.shade.technique != TerrainShade::none)
        style.shade.ambient = legible_ambient(style.shade, design.data.ground.scale, priority.least_difference);
}

DesignSettings weighted(const DesignSettings& design) noexcept {
    DesignSettings weighted = design;
    apply_priorities(design.priority.weights, weighted);
    return weighted;
}

void keep_programs(const DesignSettings& like, DesignSettings& design) noexcept {
    const auto keep = [](double other, double& strength) {
        if (other > 0) strength = std::fmax(strength, kUnseen);
    };
    const TerrainStyle& from = like.terrain.style;
    TerrainStyle& style = design.terrain.style;
    if (style.shade.technique == TerrainShade::none && from.shade.technique != TerrainShade::none) {
        style.shade.technique = from.shade.technique;
        style.shade.cast_shadows = from.shade.cast_shadows;
        style.shade.ambient = 1;
        style.shade.ambient_color = {0xFF, 0xFF, 0xFF};
    }
    if (has_colored_light(from.shade) && !has_colored_light(style.shade)) style.shade.ambient_color = {0xFF, 0xFF, 0xFE};
    const UncertaintyOverlay overlay = like.data.ground.overlay.technique;
    GroundOverlay& shown = design.data.ground.overlay;
    if (shown.technique == UncertaintyOverlay::none && overlay != UncertaintyOverlay::none) {
        shown = like.data.ground.overlay;
        shown.strength = 0;
    }
    keep(from.shade.ambient_occlusion, style.shade.ambient_occlusion);
    keep(from.shade.openness, style.shade.openness);
    for (double SketchSettings::*const line : kLines) keep(from.sketch.*line, style.sketch.*line);
}

}  // namespace tedavis::design
