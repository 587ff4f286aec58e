// The signs of the data elements: icons, names, diagrams, barbs, and the cues of hidden foci, on their sheet.
#include <optional>

#include "render_core/display/planner/element_planner.hpp"
#include "render_core/draw/data/diagrams.hpp"
#include "render_core/draw/data/ghost_signs.hpp"
#include "render_core/draw/data/motion_times.hpp"
#include "render_core/draw/data/traffic_signs.hpp"
#include "render_core/draw/data/wind_barbs.hpp"

namespace tedavis::display {
namespace {

draw::ElementCount build_billboard(draw::BillboardSheet& sheet, const draw::ElementInput& input) {
    if (input.element.technique == design::DataTechnique::diagram) return draw::add_diagrams(sheet, input);
    if (draw::shows_ghosts(input.layer)) return draw::add_ghost_signs(sheet, input);
    return draw::add_traffic_signs(sheet, input);
}

}  // namespace

/// The reports that are shown in the frame.
class ElementPlanner::LabelInputs final : public ElementLabels::Inputs {
public:
    LabelInputs(const ElementPlanner& elements, const ElementFrame& frame) : elements_(elements), frame_(frame) {}

    [[nodiscard]] const draw::ElementInput* input(const design::DataElement& element, const scene::Layer& layer) override {
        for (std::size_t n = 0; n < elements_.reports_.size(); ++n) {
            const ElementReport& report = elements_.reports_[n];
            if (report.element != &element || report.layer != &layer || report.state != ElementState::shown) continue;
            return &input_.emplace(elements_.input_of(n, frame_));
        }
        return nullptr;
    }

private:
    const ElementPlanner& elements_;
    const ElementFrame& frame_;
    std::optional<draw::ElementInput> input_;  ///< that was asked for last
};

void ElementPlanner::decide_labels(const ElementFrame& frame, double text_px) {
    labels_.decide({frame.ground, frame.view, frame.missing, frame.time, frame.own.now, text_px, frame.foci, frame.units});
}

void ElementPlanner::plan_signs(const ElementFrame& frame, const SignFrame& signs) {
    if (!signs.is_planned_again) decide_labels(frame, signs.text_px);
    sheet_.begin({signs_, links_, frame.view, signs.text_px, signs.sight, signs.symbology, static_cast<float>(signs.margin_px),
                  static_cast<float>(signs.screen_begins_px)});
    LabelInputs inputs(*this, frame);
    ElementLabels::Pass labels(labels_, sheet_, inputs, frame.declutter);
    labels.add_protected();
    plan_billboards(frame);
    labels.add_others();
    if (!signs.is_planned_again) label_counts_ = labels.count();
    for (ElementReport& report : reports_) {
        if (report.state != ElementState::shown || !has_labels(*report.element, *report.layer)) continue;
        report.count.drawn = labels_.drawn(*report.element, *report.layer);
        report.count.hidden = report.layer->entry->feature_count - report.count.drawn;
    }
    plan_glyphs(frame, &sheet_);
    plan_own_winds(frame);
    plan_motion_times(frame);
    focus_cues_ = {};
    if (frame.foci != nullptr) focus_cues_ = draw::add_focus_cues(sheet_, *frame.foci, frame.ground, frame.units);
}

void ElementPlanner::plan_detail(const ElementFrame& frame) {
    glyphs_.begin_plan();
    plan_glyphs(frame, nullptr);
}

/// Adds other aircraft and diagrams that are valid now: elements that are not shown must take no room from others.
void ElementPlanner::plan_billboards(const ElementFrame& frame) {
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        ElementReport& report = reports_[n];
        if (report.state != ElementState::shown || !is_billboard_technique(report.element->technique)) continue;
        if (!has_labels(*report.element, *report.layer)) report.count = build_billboard(sheet_, input_of(n, frame));
    }
}

/// Adds barbs of the air round the own ship, the newest first. They need no field of glyphs: they are few, and change in every
/// frame.
void ElementPlanner::plan_own_winds(const ElementFrame& frame) {
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

/// Adds the signs of storm cells, in the room that all other signs have left.
void ElementPlanner::plan_motion_times(const ElementFrame& frame) {
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        const ElementReport& report = reports_[n];
        if (report.state == ElementState::shown && report.element->technique == design::DataTechnique::prism)
            draw::add_motion_times(sheet_, mesh_, input_of(n, frame));
    }
}

}  // namespace tedavis::display
