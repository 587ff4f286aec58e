#include "render_core/display/element_legends.hpp"

#include <cmath>

#include "render_core/design/grey_of.hpp"

namespace tedavis::display {
namespace {

using design::Color;
using design::ElementUncertainty;

struct LegendFrame {
    const design::DesignSettings& design;
    const flight::FlightTime& time;
};

Color middle_color(const design::DataScale& scale) {
    const auto& stops = scale.palette.stops;
    return scale_color(scale, 0.5 * (stops[0].value + stops.back().value));
}

draw::LegendSample sample_of(std::string_view text, Color color) {
    draw::LegendSample sample;
    sample.text.append(text);
    sample.color = color;
    return sample;
}

/// What fades, at its surest and at its least sure; the unknown looks as the least sure does.
void add_fading(const design::DataElement& element, const scene::AttributeEntry& attribute, Color ground,
                draw::DataLegend& legend) {
    const bool greys = element.uncertainty == ElementUncertainty::saturation;
    if (!greys && element.uncertainty != ElementUncertainty::transparency) return;
    const Color color = middle_color(legend.scale);
    const Color faded = blended(color, greys ? grey_of(color) : ground, element.uncertainty_strength);
    static_cast<void>(legend.uncertainty.try_push_back(sample_of("SURE", color)));
    static_cast<void>(legend.uncertainty.try_push_back(sample_of(full_uncertainty_text(attribute).view(), faded)));
    static_cast<void>(legend.uncertainty.try_push_back(sample_of("UNKNOWN", faded)));
}

bool is_there(const draw::DataLegends& legends, const draw::DataLegend& entry) {
    for (const draw::DataLegend& known : legends)
        if (known.title == entry.title && known.scale.palette.name == entry.scale.palette.name &&
            known.scale.breaks.size() == entry.scale.breaks.size())
            return true;
    return false;
}

/// A full list has counted the refusal itself.
void add(const draw::DataLegend& entry, draw::DataLegends& legends) {
    if (!is_there(legends, entry)) static_cast<void>(legends.try_push_back(entry));
}

void add_colors(const ElementReport& report, const design::ColorEncoding& encoding, const LegendFrame& frame,
                draw::DataLegends& legends) {
    if (!encoding.is_used()) return;
    const scene::Attribute* const attribute = report.layer->find(encoding.attribute.view());
    if (attribute == nullptr) return;
    draw::DataLegend legend = legend_of(*report.layer, *attribute, frame.time, frame.design.data);
    legend.scale = encoding.scale;
    add_fading(*report.element, *attribute->entry, frame.design.terrain.style.plain, legend);
    static_cast<void>(legend.signs.try_push_back(sample_of("MISSING", frame.design.terrain.unknown)));
    add(legend, legends);
}

void add_uncertainty_glyphs(const ElementReport& report, const LegendFrame& frame, draw::DataLegends& legends) {
    if (!is_glyph_uncertainty(report.element->uncertainty) || report.slot == GlyphElements::kSlots) return;
    const scene::Attribute* const attribute = draw::glyph_attribute(*report.element, *report.layer);
    if (attribute == nullptr) return;
    draw::DataLegend legend = legend_of(*report.layer, *attribute, frame.time, frame.design.data);
    legend.title.append(" \xC2\xB1");
    legend.class_names.clear();
    legend.scale = uncertainty_scale(*report.element);
    const double full = static_cast<double>(attribute->entry->uncertainty_full);
    legend.factor = full > 0 ? full : 1;
    if (!(full > 0)) legend.unit.clear();
    static_cast<void>(legend.signs.try_push_back(sample_of("UNKNOWN", draw::GlyphStyle().unknown)));
    add(legend, legends);
}

}  // namespace

void add_element_legends(const ElementReports& reports, const design::DesignSettings& design, const flight::FlightTime& time,
                         draw::DataLegends& legends) noexcept {
    const LegendFrame frame{design, time};
    for (const ElementReport& report : reports) {
        if (report.state != ElementState::shown || report.count.drawn + report.count.aggregated == 0) continue;
        if (report.element->technique != design::DataTechnique::uncertainty_only)
            add_colors(report, report.element->by_color, frame, legends);
        add_colors(report, report.element->by_second_color, frame, legends);
        add_uncertainty_glyphs(report, frame, legends);
    }
}

}  // namespace tedavis::display
