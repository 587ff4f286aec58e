#include "render_core/display/planner/symbology_data.hpp"

#include <algorithm>

#include "render_core/base/units.hpp"
#include "render_core/display/planner/adjacent_data.hpp"
#include "render_core/display/planner/element_legends.hpp"
#include "render_core/display/planner/frame_notes.hpp"

namespace tedavis::display {

using flight::Signal;

namespace {

/// A position that went bad may be any. An aircraft that never states one has the markings of a plain indicator, the speeds with
/// the flaps up and the white range; where it states its lever, the flaps may be as far out as that.
policy::FlapsRange known_flaps(const flight::AircraftState& state, base::Time now) {
    if (state.is_valid(Signal::flaps_position, now)) {
        const double position = state[Signal::flaps_position].value_or(0);
        return {position, position};
    }
    if (state[Signal::flaps_position].received()) return {};
    const bool has_lever = state.is_valid(Signal::flaps_lever, now);
    return {0, has_lever ? std::clamp(state[Signal::flaps_lever].value_or(0), 0.0, 1.0) : 0};
}

/// The terrain's legend counts as one entry, and is never left out.
void state_legend(const draw::SymbologyInput& symbology, const draw::Layout& layout, LegendRecord& legend) {
    if (!symbology.shown.legend || symbology.decisions.unusual_attitude) return;
    if (layout.has_legend_rows) {
        const draw::DataLegendPlan plan = draw::plan_data_legends(symbology.data_legends, layout);
        legend.entries = static_cast<std::uint32_t>(plan.shown + (symbology.legend.ground ? 1 : 0));
        legend.left_out = static_cast<std::uint32_t>(plan.cut);
        return;
    }
    legend.entries = static_cast<std::uint32_t>(layout.key.shown);
    legend.left_out = static_cast<std::uint32_t>(layout.key.cut);
}

}  // namespace

GroundDataState add_symbology_data(const SymbologyData& frame, draw::SymbologyInput& symbology) noexcept {
    const design::DesignSettings& design = frame.design;
    add_ground_legend(frame.data, frame.plan, design, frame.time, symbology.data_legends);
    const AdjacentData adjacent =
        plan_adjacent_data(frame.data, design.data.adjacent, frame.place, frame.time, design.data.missing);
    symbology.adjacent = adjacent.maps;
    add_adjacent_legend(adjacent, frame.time, design, symbology.data_legends);
    add_element_legends(frame.reports, frame.data.scene().layers(), design, frame.time, symbology.data_legends);
    return adjacent.state;
}

policy::SpeedBands shown_speed_bands(const design::AircraftSettings& aircraft, const flight::AircraftState& state,
                                     const policy::DisplayDecisions& decisions, base::Time now) noexcept {
    const Signal speed = decisions[policy::Element::airspeed].source;
    if (speed != Signal::indicated_airspeed && speed != Signal::calibrated_airspeed) return {};
    policy::SpeedConditions conditions;
    conditions.flaps = known_flaps(state, now);
    conditions.is_on_ground = decisions.is_on_ground;
    if (state.is_valid(Signal::normal_acceleration, now))
        conditions.load_factor = state[Signal::normal_acceleration].value_or(0) / base::kStandardGravity;
    if (state.is_valid(Signal::standard_altitude, now))
        conditions.pressure_altitude_m = state[Signal::standard_altitude].value_or(0);
    return policy::speed_bands(aircraft, conditions);
}

std::uint32_t maps_drawn(const draw::SymbologyInput& symbology, const draw::Layout& layout) noexcept {
    return layout.adjacent.empty() || symbology.decisions.unusual_attitude ? 0 : draw::map_count(symbology.adjacent);
}

void flag_symbology_data(const draw::SymbologyInput& symbology, const draw::Layout& layout, GroundDataState maps,
                         FrameStatement& record) noexcept {
    state_legend(symbology, layout, record.legend);
    const bool is_cut = record.legend.left_out > 0 || (symbology.shown.legend && !layout.has_legend_rows);
    if (symbology.legend_show == flight::LegendShow::whole && is_cut && !symbology.decisions.unusual_attitude)
        flag(policy::RecordFlag::legend_cut, record);
    if (maps == GroundDataState::not_asked_for || symbology.decisions.unusual_attitude) return;
    if (maps != GroundDataState::shown) return flag(policy::RecordFlag::adjacent_missing, record);
    if (maps_drawn(symbology, layout) == 0) flag(policy::RecordFlag::adjacent_cut, record);
    if (is_in_another_unit(symbology.adjacent.view.scale.palette, *symbology.adjacent.attribute->entry) &&
        symbology.adjacent.view.shows != design::AdjacentShows::uncertainty)
        flag(policy::RecordFlag::adjacent_unit, record);
}

}  // namespace tedavis::display
