/// Displays over hills of 1000 m at 47.0 N 9.7 E, and their pictures.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "render_core/base/units.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::test_support {

inline constexpr base::Time kHillsNow{1'700'000'000'000'000'000};

/// Hills of 1000 m at 47.0 N 9.7 E, and a database of them.
inline const BuiltDatabase& hills() {
    static const BuiltDatabase built(make_rough_raster(241, 241));
    return built;
}

/// In the middle of the hills at a height above MSL, everything valid.
inline flight::AircraftState aircraft_over_hills(double msl_m, double heading_deg = 30, double pitch_deg = 2,
                                                 double roll_deg = 0) {
    flight::AircraftState state;
    const auto set = [&](flight::Signal signal, double value) { state[signal] = {value, kHillsNow}; };
    const double latitude = base::radians(47.0), longitude = base::radians(9.7);
    const double ellipsoid_m = msl_m + hills().database.undulation(latitude, longitude).m;
    set(flight::Signal::latitude, latitude);
    set(flight::Signal::longitude, longitude);
    set(flight::Signal::ellipsoid_height, ellipsoid_m);
    set(flight::Signal::pitch, base::radians(pitch_deg));
    set(flight::Signal::roll, base::radians(roll_deg));
    set(flight::Signal::true_heading, base::radians(heading_deg));
    set(flight::Signal::true_track, base::radians(heading_deg));
    set(flight::Signal::ground_speed, 60);
    set(flight::Signal::indicated_airspeed, 60);
    set(flight::Signal::baro_altitude, msl_m);
    set(flight::Signal::vertical_speed, 0);
    set(flight::Signal::height_above_terrain, msl_m - 1000);
    state.own_ship.position = {latitude, longitude, {ellipsoid_m}};
    state.own_ship.velocity_north_mps = 60 * std::cos(base::radians(heading_deg));
    state.own_ship.velocity_east_mps = 60 * std::sin(base::radians(heading_deg));
    state.own_ship.height_is_geometric = true;
    state.own_ship.at = kHillsNow;
    state.own_ship.state = base::SignalState::valid;
    return state;
}

struct HillsPicture {
    std::vector<std::uint8_t> rgba;
    std::uint32_t width = 0, height = 0;
    /// From the top left corner.
    [[nodiscard]] const std::uint8_t* at(std::uint32_t x, std::uint32_t y) const {
        return rgba.data() + (std::size_t{height - 1 - y} * width + x) * 4;
    }
    /// Mean of a channel round a place, from the top left corner.
    [[nodiscard]] double mean(double x, double y, std::size_t channel) const {
        double sum = 0;
        for (int dy = -2; dy <= 2; ++dy)
            for (int dx = -2; dx <= 2; ++dx)
                sum += at(static_cast<std::uint32_t>(x + dx), static_cast<std::uint32_t>(y + dy))[channel];
        return sum / 25;
    }
    [[nodiscard]] bool is_sky(std::uint32_t x, std::uint32_t y) const {
        return at(x, y)[2] > at(x, y)[1] && at(x, y)[1] > at(x, y)[0];
    }
};
inline bool operator==(const HillsPicture& a, const HillsPicture& b) { return a.rgba == b.rgba; }
inline bool operator!=(const HillsPicture& a, const HillsPicture& b) { return !(a == b); }

/// With all terrain arrived.
inline HillsPicture hills_picture(HeadlessDisplay& display, const flight::AircraftState& state,
                                  const flight::PhaseStatus& phase = {}, base::Time now = kHillsNow) {
    return {settled_pixels(display, state, now, phase), display.surface().width(), display.surface().height()};
}

inline bool has_flag(const HeadlessDisplay& display, std::string_view name) {
    const auto& flags = const_cast<HeadlessDisplay&>(display).display().record().flags;
    return std::any_of(flags.begin(), flags.end(), [&](const display::Name& flag) { return flag.view() == name; });
}

/// A display over the hills; the image may be damaged before.
struct OverHills {
    MemoryBytes bytes;
    HeadlessDisplay display;
    explicit OverHills(const std::vector<std::uint8_t>& image = hills().image, const std::string& device = "es3-mid",
                       std::uint32_t width = 320, std::uint32_t height = 240)
        : bytes(image), display("egl", device, width, height, &bytes) {}
    /// The default design with the warning bands of its profile.
    void show_bands() {
        design::DesignSettings design = shipped_design("default");
        design.warning_colors = true;
        EXPECT_TRUE(display.display().set_design(design));
    }
};

}  // namespace tedavis::test_support
