#include "render_core/draw/data/glyph_focus.hpp"

#include <cmath>

#include "render_core/draw/data/glyph_sites.hpp"

namespace tedavis::draw {
namespace {

/// Of wind glyphs show the speed.
bool shows(const design::DataElement& element, const scene::Layer& layer, std::string_view attribute) {
    const scene::Attribute* const shown = glyph_attribute(element, layer);
    if (shown == nullptr) return false;
    return glyph_values(layer, *shown) == scene::GlyphValues::wind ? attribute == "speed" : attribute == shown->entry->name;
}

}  // namespace

scene::GlyphFocus glyph_focus(const FrameFoci* foci, const design::DataElement& element, const scene::Layer& layer,
                              double coarsest) {
    scene::GlyphFocus focus;
    if (foci == nullptr) return focus;
    focus.regions = &foci->regions;
    focus.ranges = foci->ranges;
    focus.least_degree = std::fmax(foci->least_degree, 1.0 / scene::GlyphFocus::kSteps);
    focus.hides_context = foci->look.context == design::FocusContextData::hidden;
    for (std::size_t n = 0; n < foci->regions.size(); ++n) {
        const design::FocusSettings& settings = (*foci->foci)[n];
        focus.by_value[n] = settings.shape == design::FocusShape::data && is_meant(settings.data, layer) &&
                            shows(element, layer, settings.data.attribute.view());
    }
    for (std::size_t n = 0; n <= scene::GlyphFocus::kSteps; ++n) {
        const FocusLook look = look_at(*foci, static_cast<double>(n) / scene::GlyphFocus::kSteps);
        focus.coarser[n] = std::pow(coarsest, 1 - look.detail);
        focus.across[n] = look.aggregate;
    }
    return focus;
}

}  // namespace tedavis::draw
