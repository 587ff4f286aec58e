#include "render_core/draw/symbology/symbology.hpp"

#include "render_core/draw/symbology/annunciations.hpp"
#include "render_core/draw/symbology/course_deviation.hpp"
#include "render_core/draw/symbology/flight_director.hpp"
#include "render_core/draw/symbology/map_symbols.hpp"

namespace tedavis::draw {

void build_symbology(QuadBatch& batch, const SymbologyInput& input, const Layout& layout) {
    batch.clear();
    const Painter painter(batch, layout, input.palette);
    const bool ahead = input.over == SymbolGround::perspective;
    if (input.shown.attitude && ahead) build_attitude(painter, input);
    if (input.shown.flight_path && ahead) {
        build_path_reference(painter, input);
        build_flight_director(painter, input);
        build_flight_path(painter, input);
    }
    if (input.shown.map && input.over == SymbolGround::map) build_map_symbols(painter, input);
    if (input.shown.airspeed) build_airspeed(painter, input);
    if (input.shown.altitude) build_altitude(painter, input);
    if (input.shown.vertical_speed) build_vertical_speed(painter, input);
    if (input.shown.heading) build_heading(painter, input);
    if (input.shown.heading && !input.decisions.unusual_attitude) build_vertical_deviation(painter, input);
    if (input.shown.baro_setting) build_baro_setting(painter, input);
    if (input.shown.ground_height) build_ground_height(painter, input);
    if (input.shown.air) build_air(painter, input);
    if (input.shown.attitude && ahead) build_field_of_view(painter, input);
    if (input.shown.legend) build_legend(painter, input);
    if (!input.decisions.unusual_attitude) build_adjacent_maps(painter, input);
    build_annunciations(painter, input);  // no design can switch notices off
    build_information(painter, input);
}

}  // namespace tedavis::draw
