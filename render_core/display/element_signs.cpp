// The signs of the data elements: icons, names, diagrams, barbs, and the cues of hidden foci, on their sheet.
#include "render_core/display/data_elements.hpp"
#include "render_core/draw/data/billboards.hpp"
#include "render_core/draw/data/diagrams.hpp"
#include "render_core/draw/data/traffic_signs.hpp"
#include "render_core/draw/data/wind_barbs.hpp"

namespace tedavis::display {
namespace {

bool is_traffic(const scene::Layer& layer) {
    return layer.entry->role == scene::LayerRole::traffic && layer.entry->shape == scene::LayerShape::lines;
}

draw::ElementCount build_billboard(draw::BillboardSheet& sheet, const draw::ElementInput& input) {
    if (input.element.technique == design::DataTechnique::diagram) return draw::add_diagrams(sheet, input);
    return is_traffic(input.layer) ? draw::add_traffic_signs(sheet, input) : draw::add_billboards(sheet, input);
}

}  // namespace

/// Only what is valid now: what is not shown must take no room from what is.
void DataElements::plan_signs(const ElementFrame& frame, const SignFrame& signs) {
    sheet_.begin({sign_drawer_.batch(), link_drawer_.batch(), frame.view, signs.text_px, signs.sight, signs.symbology,
                  static_cast<float>(signs.margin_px), static_cast<float>(signs.screen_begins_px)});
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        ElementReport& report = reports_[n];
        if (report.state != ElementState::shown || !is_billboard_technique(report.element->technique)) continue;
        const draw::ElementInput input = input_of(n, frame);
        report.count = build_billboard(sheet_, input);
    }
    plan_glyphs(frame, &sheet_);
    plan_own_winds(frame);
    focus_cues_ = {};
    if (frame.foci != nullptr) focus_cues_ = draw::add_focus_cues(sheet_, *frame.foci, frame.ground, signs.is_metric);
}

/// Barbs of the air round the own ship, the newest first; no field: there are few, and they are new in every frame.
void DataElements::plan_own_winds(const ElementFrame& frame) {
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        ElementReport& report = reports_[n];
        if (report.state != ElementState::shown || report.element->own != design::OwnData::wind) continue;
        const base::Span<const scene::SelectedGlyph> glyphs = own_.wind_glyphs(frame.view.eye);
        report.count = {};
        for (std::size_t glyph = glyphs.size(); glyph-- > 0;) {
            const draw::ElementCount one = draw::add_wind_barbs(sheet_, input_of(n, frame), glyphs.subspan(glyph, 1));
            report.count.drawn += one.drawn;
            report.count.hidden += one.hidden;
        }
    }
}

}  // namespace tedavis::display
