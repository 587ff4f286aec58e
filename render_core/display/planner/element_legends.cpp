#include "render_core/display/planner/element_legends.hpp"

#include <cmath>

#include "render_core/design/grey_of.hpp"
#include "render_core/display/planner/sign_legend.hpp"

namespace tedavis::display {
namespace {

using design::Color;
using design::ElementUncertainty;

struct LegendFrame {
    const design::DesignSettings& design;
    const flight::FlightTime& time;
    base::Span<const scene::Layer> layers;

    /// Whose time and source the attribute has; null: its own layer.
    [[nodiscard]] const scene::Layer* made_of(const scene::Attribute& attribute) const {
        const std::size_t number = attribute.entry->derived_from;
        return number == 0 || number > layers.size() ? nullptr : &layers[number - 1];
    }
};

Color middle_color(const design::DataScale& scale) {
    if (!scale.breaks.empty()) return color_of_class(scale, scale.breaks.size() / 2);
    const auto& stops = scale.palette.stops;
    return scale_color(scale, 0.5 * (stops[0].value + stops.back().value));
}

draw::LegendSample sample_of(std::string_view text, Color color) {
    draw::LegendSample sample;
    sample.text.append(text);
    sample.color = color;
    return sample;
}

/// The look of an unknown uncertainty: signs have a question mark, glyphs a colour of their own, and surfaces are crossed by
/// stripes.
draw::LegendSample unknown_sample(const ElementReport& report, Color color, Color faded, Color ground) {
    draw::LegendSample sample = sample_of(draw::kUnknownText, color);
    if (is_sign_technique(report.element->technique)) {
        sample.look = draw::SampleLook::question;
        sample.color = faded;
    } else if (report.slot != GlyphElements::kSlots) {
        sample.color = draw::GlyphStyle().unknown;
    } else {
        sample.look = draw::SampleLook::cut_stripes;
        sample.under = ground;
    }
    return sample;
}

/// Samples of a look that fades: at no uncertainty, at the greatest one, and for the unknown, which is neither.
void add_fading(const ElementReport& report, const scene::Attribute& attribute, const design::DesignSettings& design,
                draw::DataLegend& legend) {
    const design::DataElement& element = *report.element;
    const bool greys = element.uncertainty == ElementUncertainty::saturation;
    if (!greys && element.uncertainty != ElementUncertainty::transparency) return;
    const Color color = middle_color(legend.scale);
    const Color faded = blended(color, greys ? grey_of(color) : design.terrain.style.plain, element.uncertainty_strength);
    if (attribute.states_uncertainty()) {
        static_cast<void>(legend.uncertainty.try_push_back(sample_of("CERTAIN", color)));
        static_cast<void>(legend.uncertainty.try_push_back(
            sample_of(full_uncertainty_text(*attribute.entry, design.symbology.units).view(), faded)));
    }
    static_cast<void>(legend.uncertainty.try_push_back(unknown_sample(report, color, faded, design.terrain.style.plain)));
}

void add_colors(const ElementReport& report, const design::ColorEncoding& encoding, const LegendFrame& frame,
                draw::DataLegends& legends) {
    if (!encoding.is_used()) return;
    const scene::Attribute* const attribute = report.layer->find(encoding.attribute.view());
    if (attribute == nullptr) return;
    draw::DataLegend legend = legend_of(*report.layer, *attribute, frame.time, frame.design, frame.made_of(*attribute));
    legend.scale = encoding.scale;
    keep_named_classes(*attribute, UINT32_MAX, legend);
    add_fading(report, *attribute, frame.design, legend);
    static_cast<void>(legend.signs.try_push_back(sample_of("MISSING", frame.design.data.missing)));
    add_legend(legend, legends);
}

void add_uncertainty_glyphs(const ElementReport& report, const LegendFrame& frame, draw::DataLegends& legends) {
    if (!is_glyph_uncertainty(report.element->uncertainty) || report.slot == GlyphElements::kSlots) return;
    const scene::Attribute* const attribute = draw::glyph_attribute(*report.element, *report.layer);
    if (attribute == nullptr) return;
    draw::DataLegend legend = uncertainty_legend_of(*report.layer, *attribute, frame.time, frame.design);
    legend.scale = uncertainty_scale(*report.element);
    static_cast<void>(legend.signs.try_push_back(sample_of(draw::kUnknownText, draw::GlyphStyle().unknown)));
    add_legend(legend, legends);
}

}  // namespace

void add_element_legends(const ElementReports& reports, base::Span<const scene::Layer> layers,
                         const design::DesignSettings& design, const flight::FlightTime& time,
                         draw::DataLegends& legends) noexcept {
    const LegendFrame frame{design, time, layers};
    for (const ElementReport& report : reports) {
        if (report.state != ElementState::shown) continue;
        // Signs find their room when the legends have theirs.
        const bool is_planned = !is_sign_technique(report.element->technique);
        if (is_planned && report.count.drawn + report.count.aggregated == 0) continue;
        if (report.element->technique != design::DataTechnique::uncertainty_only)
            add_colors(report, report.element->by_color, frame, legends);
        add_colors(report, report.element->by_second_color, frame, legends);
        add_uncertainty_glyphs(report, frame, legends);
    }
    add_sign_legend(reports, design, legends);
}

}  // namespace tedavis::display
