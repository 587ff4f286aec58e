#include "render_core/draw/symbology/symbology_input.hpp"

#include <algorithm>

#include "render_core/earth/geodetic.hpp"

namespace tedavis::draw {
namespace {

using flight::Signal;
using policy::Element;

/// 0 for an element that shows no signal.
double shown_value(const flight::AircraftState& state, const policy::DisplayDecisions& decisions, Element element) {
    const Signal source = decisions[element].source;
    return source == Signal::count_ ? 0 : state[source].value_or(0);
}

LegendInput make_legend_input(const policy::DisplayDecisions& decisions, const design::DesignSettings& design) {
    LegendInput legend;
    legend.ground = decisions.show_terrain;
    legend.tint = decisions.show_terrain && design::colors_by_palette(design.terrain.style.texture);
    legend.bands = decisions.show_terrain && decisions.show_warning_colors;
    legend.palette = design.terrain.palette;
    legend.plain = design.terrain.style.plain;
    legend.sea = design.terrain.sea;
    legend.unknown = design.terrain.unknown;
    legend.warning_bands = design.warning_bands;
    legend.units = design.symbology.units;
    return legend;
}

std::optional<base::Time> position_time(const flight::AircraftState& state) {
    const auto &latitude = state[Signal::latitude], &longitude = state[Signal::longitude];
    if (state.is_posed || !latitude.received() || !longitude.received()) return std::nullopt;
    return std::min(latitude.source_time(), longitude.source_time());
}

void take_air(const flight::AircraftState& state, base::Time now, SymbologyInput& input) {
    const auto age = [&](Signal signal) { return now - state[signal].source_time(); };
    input.wind_speed_mps = state[Signal::wind_speed].value_or(0);
    input.wind_from_rad = state[Signal::wind_direction].value_or(0);
    input.wind_age = std::max(age(Signal::wind_speed), age(Signal::wind_direction));
    input.outside_temperature_k = state[Signal::outside_temperature].value_or(0);
    input.temperature_age = age(Signal::outside_temperature);
}

GuidanceInput make_guidance_input(const flight::AircraftState& state, const policy::DisplayDecisions& decisions) {
    const auto value = [&](Element element) { return shown_value(state, decisions, element); };
    GuidanceInput guidance;
    guidance.slip_mps2 = value(Element::slip);
    guidance.turn_rate_radps = value(Element::turn_rate);
    guidance.course_rad = value(Element::course);
    guidance.waypoint_bearing_rad = value(Element::waypoint_bearing);
    guidance.selected_heading_rad = value(Element::selected_heading);
    guidance.lateral_deviation = value(Element::lateral_deviation);
    guidance.vertical_deviation = value(Element::vertical_deviation);
    guidance.navigation_source = decisions.navigation_source;
    guidance.path_reference_rad = value(Element::flight_path_reference);
    if (decisions[Element::flight_director].source != Signal::count_) {
        guidance.director_pitch_rad = state[Signal::flight_director_pitch].value_or(0);
        guidance.director_roll_rad = state[Signal::flight_director_roll].value_or(0);
    }
    guidance.selected_altitude_m = value(Element::selected_altitude);
    guidance.selected_airspeed_mps = value(Element::selected_airspeed);
    guidance.selected_vertical_speed_mps = value(Element::selected_vertical_speed);
    guidance.airspeed_rate_mps2 = value(Element::airspeed_trend);
    guidance.radio_minimum_m = value(Element::radio_minimum);
    guidance.baro_minimum_m = value(Element::baro_minimum);
    return guidance;
}

/// A magnetic heading needs the variation; the others are true. Nothing is placed by a heading that is not valid.
double from_true_rad(const flight::AircraftState& state, const policy::DisplayDecisions& decisions, base::Time now) {
    const double unknown = std::nan("");
    const policy::ElementShow heading = decisions[Element::heading].show;
    if (heading != policy::ElementShow::normal && heading != policy::ElementShow::substituted) return unknown;
    if (decisions[Element::heading].source != Signal::magnetic_heading) return 0;
    return state.is_valid(Signal::magnetic_variation, now) ? -state[Signal::magnetic_variation].value_or(0) : unknown;
}

double true_direction_rad(const flight::AircraftState& state, Signal source) {
    if (source == Signal::count_) return 0;
    const double direction = state[source].value_or(0);
    if (source != Signal::magnetic_heading) return direction;
    return earth::wrap_heading(direction + state[Signal::magnetic_variation].value_or(0));
}

}  // namespace

double view_heading_rad(const flight::AircraftState& state, const policy::DisplayDecisions& decisions) noexcept {
    return true_direction_rad(state, decisions.view_heading);
}

double map_up_rad(const flight::AircraftState& state, const policy::DisplayDecisions& decisions) noexcept {
    return true_direction_rad(state, decisions[Element::map_up].source);
}

SymbologyInput make_symbology_input(const flight::AircraftState& state, const policy::DisplayDecisions& decisions,
                                    const flight::PhaseStatus& phase, const design::DesignSettings& design, base::Time now,
                                    std::uint32_t width, std::uint32_t height, double gnss_msl_m) noexcept {
    SymbologyInput input;
    input.decisions = decisions;
    input.shown = design.symbology;
    input.unusual = design.unusual_attitude;
    input.sky = design.sky.zenith;
    input.ground = design.sky.ground;
    input.phase = phase;
    input.position_time = position_time(state);
    input.legend = make_legend_input(decisions, design);
    input.view_heading_rad = view_heading_rad(state, decisions);
    input.pitch_rad = state[Signal::pitch].value_or(0);
    input.roll_rad = state[Signal::roll].value_or(0);
    input.view = make_view_frame(width, height, design.view.horizontal_field_of_view_rad, input.view_heading_rad, input.pitch_rad,
                                 input.roll_rad);
    input.heading_rad = shown_value(state, decisions, Element::heading);
    input.airspeed_mps = shown_value(state, decisions, Element::airspeed);
    const bool gnss = decisions[Element::altitude].source == Signal::ellipsoid_height;
    input.altitude_m = gnss ? gnss_msl_m : shown_value(state, decisions, Element::altitude);
    input.vertical_speed_mps = shown_value(state, decisions, Element::vertical_speed);
    input.baro_setting_pa = shown_value(state, decisions, Element::baro_setting);
    input.ground_height_m = shown_value(state, decisions, Element::ground_height);
    take_air(state, now, input);
    input.guidance = make_guidance_input(state, decisions);
    input.shows_track = state.is_valid(Signal::true_track, now);
    input.track_rad = state[Signal::true_track].value_or(0);
    input.from_true_rad = from_true_rad(state, decisions, now);
    input.velocity_north_mps = state.own_ship.velocity_north_mps;
    input.velocity_east_mps = state.own_ship.velocity_east_mps;
    input.velocity_up_mps = state.own_ship.velocity_up_mps;
    return input;
}

}  // namespace tedavis::draw
