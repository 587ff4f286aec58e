#include "render_core/display/planner/symbology_data.hpp"

#include "render_core/display/planner/adjacent_data.hpp"
#include "render_core/display/planner/element_legends.hpp"
#include "render_core/display/planner/frame_notes.hpp"

namespace tedavis::display {

GroundDataState add_symbology_data(const SymbologyData& frame, draw::SymbologyInput& symbology) noexcept {
    const design::DesignSettings& design = frame.design;
    add_ground_legend(frame.data, frame.plan, design, frame.time, symbology.data_legends);
    const AdjacentData adjacent =
        plan_adjacent_data(frame.data, design.data.adjacent, frame.place, frame.time, design.terrain.unknown);
    symbology.adjacent = adjacent.maps;
    add_adjacent_legend(adjacent, frame.time, design, symbology.data_legends);
    add_element_legends(frame.reports, frame.data.scene().layers(), design, frame.time, symbology.data_legends);
    return adjacent.state;
}

std::uint32_t maps_drawn(const draw::SymbologyInput& symbology, const draw::Layout& layout) noexcept {
    return layout.adjacent.empty() || symbology.decisions.unusual_attitude ? 0 : draw::map_count(symbology.adjacent);
}

void flag_symbology_data(const draw::SymbologyInput& symbology, const draw::Layout& layout, GroundDataState maps,
                         FrameStatement& record) noexcept {
    if (symbology.shown.legend && draw::plan_data_legends(symbology.data_legends, layout).cut > 0) flag("legend.cut", record);
    if (maps == GroundDataState::not_asked_for || symbology.decisions.unusual_attitude) return;
    if (maps != GroundDataState::shown) return flag("adjacent.missing", record);
    if (maps_drawn(symbology, layout) == 0) flag("adjacent.cut", record);
    if (is_in_another_unit(symbology.adjacent.view.scale.palette, *symbology.adjacent.attribute->entry) &&
        symbology.adjacent.view.shows != design::AdjacentShows::uncertainty)
        flag("adjacent.unit", record);
}

}  // namespace tedavis::display
