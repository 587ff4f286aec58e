/// The map over the hills: aircraft, designs and pictures of a display of its own.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "render_core/base/units.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::test_support {

inline constexpr double kMapGround_m = 1000;

struct MapPlace {
    double latitude_deg = 47.0, longitude_deg = 9.7;
};

/// Everything valid, 1000 m above the ground.
inline flight::AircraftState aircraft_on_map(const MapPlace& place = {}, double heading_deg = 30, double track_deg = 30,
                                             double msl_m = 2 * kMapGround_m) {
    flight::AircraftState state;
    const auto set = [&](flight::Signal signal, double value) { state[signal] = {value, kHillsNow}; };
    set(flight::Signal::latitude, base::radians(place.latitude_deg));
    set(flight::Signal::longitude, base::radians(place.longitude_deg));
    set(flight::Signal::ellipsoid_height, msl_m);
    set(flight::Signal::pitch, base::radians(2));
    set(flight::Signal::roll, base::radians(-10));
    set(flight::Signal::true_heading, base::radians(heading_deg));
    set(flight::Signal::true_track, base::radians(track_deg));
    set(flight::Signal::indicated_airspeed, 60);
    set(flight::Signal::baro_altitude, msl_m);
    set(flight::Signal::vertical_speed, 0);
    set(flight::Signal::height_above_terrain, msl_m - kMapGround_m);
    state.own_ship.position = {base::radians(place.latitude_deg), base::radians(place.longitude_deg), {msl_m}};
    state.own_ship.velocity_north_mps = 60;
    state.own_ship.height_is_geometric = true;
    state.own_ship.at = kHillsNow;
    state.own_ship.state = base::SignalState::valid;
    return state;
}

/// All signals again, later.
inline flight::AircraftState received_later(flight::AircraftState state, base::Time now) {
    for (auto& signal : state.signals)
        if (signal.received()) signal = {signal.value_or(0), now};
    state.own_ship.at = now;
    return state;
}

inline design::DesignSettings without_symbols(design::DesignSettings design) {
    design.symbology = {};
    for (bool* shown :
         {&design.symbology.attitude, &design.symbology.map, &design.symbology.heading, &design.symbology.airspeed,
          &design.symbology.altitude, &design.symbology.vertical_speed, &design.symbology.flight_path,
          &design.symbology.baro_setting, &design.symbology.ground_height, &design.symbology.phase, &design.symbology.legend})
        *shown = false;
    return design;
}

inline design::DesignSettings map_design(double range_m = 5000, const std::string& name = "map_north_up") {
    design::DesignSettings design = shipped_design(name);
    design.view.map_range_m = range_m;
    return design;
}

/// The same terrain in 3D, so that one display can show both.
inline design::DesignSettings in_three_d(design::DesignSettings design) {
    design.view.mode = design::ViewMode::perspective;
    return design;
}

/// One at a time: its surface is current.
struct MapScene {
    MemoryBytes bytes;
    HeadlessDisplay headless;

    explicit MapScene(const design::DesignSettings& design, const BuiltDatabase& terrain = hills(),
                      const std::string& device = "es3-mid", std::uint32_t width = 640, std::uint32_t height = 480,
                      base::ByteSource* scene = nullptr)
        : bytes(terrain.image), headless("egl", device, width, height, &bytes, design, as_it_is, scene) {}
    MapScene(const MapScene&) = delete;
    MapScene& operator=(const MapScene&) = delete;
    [[nodiscard]] display::Display& display() { return headless.display(); }
    [[nodiscard]] const display::FrameRecord& record() { return display().record(); }

    /// With all terrain arrived.
    HillsPicture picture(const flight::AircraftState& state, base::Time now = kHillsNow) {
        display::settle(display(), {state, {}, now});
        display().plan({state, {}, now});
        return drawn();
    }
    HillsPicture drawn() { return {drawn_pixels(headless), headless.surface().width(), headless.surface().height()}; }
    [[nodiscard]] bool has_flag(std::string_view name) {
        const auto& flags = record().flags;
        return std::any_of(flags.begin(), flags.end(), [&](const display::Name& flag) { return flag.view() == name; });
    }
};

/// Of a display of its own.
inline HillsPicture map_picture(const design::DesignSettings& design, const flight::AircraftState& state,
                                base::Time now = kHillsNow) {
    MapScene scene(design);
    return scene.picture(state, now);
}

}  // namespace tedavis::test_support
