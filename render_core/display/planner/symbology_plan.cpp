#include "render_core/display/planner/symbology_plan.hpp"

#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::display {
namespace {

void set_terrain_legend(const FrameContext& frame, draw::LegendInput& legend) {
    if (frame.design.terrain.palette.kind == design::PaletteKind::hypsometric) {
        legend.lowest = frame.heights.lowest_m;
        legend.highest = frame.heights.highest_m;
    }
    legend.bands_lowered_m = frame.record.bands.lowered_m;
    legend.accuracy_assumed = frame.record.bands.position_assumed || frame.record.bands.terrain_assumed;
}

}  // namespace

double text_px(const FrameContext& frame, std::uint32_t width, std::uint32_t height) {
    return static_cast<double>(draw::make_layout(width, height, frame.design.view.dpi).text_px);
}

MapsBeside plan_symbology(const SymbologyFrame& planned, draw::QuadBatch& batch, FrameStatement& record) {
    const FrameContext& frame = planned.frame;
    draw::SymbologyInput symbology =
        draw::make_symbology_input(planned.state, frame.decisions, frame.record.phase, frame.design, frame.record.time,
                                   planned.width, planned.height, frame.aircraft_msl_m);
    symbology.palette = planned.palette;
    set_terrain_legend(frame, symbology.legend);
    symbology.excessive_bank_rad = planned.aircraft.excessive_bank_rad;
    symbology.standard_turn_radps = planned.aircraft.standard_turn_rad_s;
    symbology.bands = shown_speed_bands(planned.aircraft, planned.state, frame.decisions, frame.record.time);
    symbology.legend_show = planned.legend;
    symbology.over = planned.over;
    symbology.map = make_map_input(frame, planned.state);
    MapsBeside maps;
    if (frame.decisions.show_terrain)
        maps.state = add_symbology_data({planned.data, planned.data_plan, planned.reports, frame.design,
                                         planned.state.own_ship.position, frame.record.flight_time},
                                        symbology);
    const draw::Layout layout =
        draw::make_layout(planned.width, planned.height, frame.design.view.dpi, draw::legend_need(symbology));
    draw::build_symbology(batch, symbology, layout);
    flag_symbology_data(symbology, layout, maps.state, record);
    maps.drawn = maps_drawn(symbology, layout);
    return maps;
}

}  // namespace tedavis::display
