#include "render_core/display/planner/element_report.hpp"

namespace tedavis::display {

using design::DataTechnique;

bool is_billboard_technique(DataTechnique technique) noexcept {
    return technique == DataTechnique::billboard || technique == DataTechnique::diagram;
}

bool any_is_out_of_date(const ElementReports& reports) noexcept {
    for (const ElementReport& report : reports)
        if (report.state == ElementState::out_of_date) return true;
    return false;
}

const char* reason_of(ElementState state) noexcept {
    switch (state) {
        case ElementState::shown: return "asked for by the design";
        case ElementState::no_such_layer: return "the scene has no such layer";
        case ElementState::not_measured: return "the aircraft has stated nothing to show";
        case ElementState::wrong_layer: return "the technique does not show layers of this kind";
        case ElementState::no_room: return "the device has no room for one more";
        case ElementState::out_of_date: return "the data are not valid at this time";
        case ElementState::no_terrain: return "no terrain is shown";
    }
    return "unknown";
}

bool is_drawn(const ElementReport& report) noexcept {
    return report.state == ElementState::shown && report.count.drawn + report.count.aggregated > 0;
}

bool shows_uncertainty(const ElementReport& report) noexcept {
    return is_drawn(report) && report.element->uncertainty != design::ElementUncertainty::none && report.layer != nullptr &&
           report.layer->states_uncertainty();
}

bool is_sign_technique(DataTechnique technique) noexcept {
    return is_billboard_technique(technique) || technique == DataTechnique::barbs;
}

}  // namespace tedavis::display
