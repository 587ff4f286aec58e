#include "tests/support/draw/symbology_scene.hpp"

#include <cmath>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::test_support {

using flight::Signal;

flight::AircraftState scene_state(double heading_deg, double pitch_deg, double roll_deg) {
    flight::AircraftState state;
    const auto set = [&](Signal signal, double value) { state[signal] = {value, kSceneNow}; };
    for (std::size_t i = 0; i < flight::kSignalCount; ++i) set(static_cast<Signal>(i), 0);
    set(Signal::true_heading, base::radians(heading_deg));
    set(Signal::true_track, base::radians(heading_deg));
    set(Signal::pitch, base::radians(pitch_deg));
    set(Signal::roll, base::radians(roll_deg));
    set(Signal::indicated_airspeed, 128 * base::kMpsPerKnot);
    set(Signal::baro_altitude, 4520 * base::kMetresPerFoot);
    set(Signal::true_altitude, 4600 * base::kMetresPerFoot);
    set(Signal::ellipsoid_height, 4500 * base::kMetresPerFoot);
    set(Signal::standard_altitude, 4700 * base::kMetresPerFoot);
    set(Signal::vertical_speed, -500 * base::kMpsPerFootPerMinute);
    set(Signal::baro_setting, 100'900);
    set(Signal::radio_height, 1240 * base::kMetresPerFoot);
    set(Signal::height_above_terrain, 1250 * base::kMetresPerFoot);
    state.own_ship.state = base::SignalState::valid;
    state.own_ship.height_is_geometric = true;
    state.own_ship.velocity_north_mps = 65 * std::cos(base::radians(heading_deg));
    state.own_ship.velocity_east_mps = 65 * std::sin(base::radians(heading_deg));
    state.own_ship.velocity_up_mps = -2.54;
    return state;
}

policy::DisplayConditions scene_conditions() {
    policy::DisplayConditions conditions;
    conditions.terrain = policy::TerrainSource::ready;
    conditions.phase.phase = flight::kApproachFinal;
    conditions.phase.source = flight::PhaseSource::switches;
    conditions.generated_flight = true;
    return conditions;
}

draw::SymbologyInput scene_input(const flight::AircraftState& state, std::uint32_t width, std::uint32_t height,
                                 const policy::DisplayConditions& conditions) {
    const design::DesignSettings design = design::default_design_settings();
    const policy::DisplayDecisions decisions = policy::decide_display(state, kSceneNow, conditions, design);
    draw::SymbologyInput input =
        draw::make_symbology_input(state, decisions, conditions.phase, design, kSceneNow, width, height, 1380);
    input.legend_show = flight::LegendShow::whole;
    return input;
}

std::string text_of(const draw::QuadBatch& batch) {
    const draw::FontAtlas& atlas = draw::font_atlas();
    std::string text;
    const auto vertices = batch.vertices();
    for (std::size_t i = 0; i + 3 < vertices.size(); ++i) {
        // A glyph's first corner is followed by three of the same extent.
        const auto is_glyph = [&](std::size_t n) { return vertices[n].extent_x == -1.0f; };
        if (!is_glyph(i)) continue;
        const float u = (vertices[i].u + vertices[i + 2].u) / 2 * static_cast<float>(atlas.width);
        const float v = (vertices[i].v + vertices[i + 2].v) / 2 * static_cast<float>(atlas.height);
        for (const draw::Glyph& glyph : atlas.glyphs)
            if (u > glyph.u && u < glyph.u + glyph.width && v > glyph.v && v < glyph.v + glyph.height)
                text += static_cast<char>(glyph.code_point);
        i += 3;
    }
    return text;
}

}  // namespace tedavis::test_support
