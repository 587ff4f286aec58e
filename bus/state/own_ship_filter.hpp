/// Estimates the own ship's position and velocity at any instant from messages that arrive one by one, each with its own source
/// time.
///
/// Latitude, longitude and height are filtered separately (axis_filter.hpp), because each is a separate message. Metres per
/// radian follow the WGS84 radii at the current place, so nothing is tied to a fixed origin: poles, the antimeridian and long
/// flights need no re-basing. Up to the extrapolation limit the estimate is extrapolated with its velocity; after that it is
/// held and is stale, later lost.
///
/// Height: that of GNSS above the ellipsoid; where that is unusable the altimeter's altitude, else the standard altitude, and
/// then `height_is_geometric` is false. Thread  one. Memory  fixed, trivially copyable.
#pragma once

#include <array>
#include <cstdint>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/state/axis_filter.hpp"
#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::bus {

enum class HeightSource : std::uint8_t { ellipsoid, baro, standard };
inline constexpr std::size_t kHeightSources = 3;

class OwnShipFilter {
public:
    explicit OwnShipFilter(const OwnShipSettings& settings = OwnShipSettings());

    void add_latitude(double latitude_rad, base::Time at);
    void add_longitude(double longitude_rad, base::Time at);
    void add_height(HeightSource source, double height_m, base::Time at);
    /// Ground speed and track become a velocity when both were measured within kPairing.
    void add_ground_speed(double speed_mps, base::Time at);
    void add_true_track(double track_rad, base::Time at);
    void add_north_velocity(double velocity_mps, base::Time at);
    void add_east_velocity(double velocity_mps, base::Time at);
    void add_up_velocity(double velocity_mps, base::Time at);
    /// Figures of merit, taken as two standard deviations; they replace the settings' noise.
    void set_horizontal_accuracy(double accuracy_m);
    void set_vertical_accuracy(double accuracy_m);
    /// The sender says that it has no position or height; holds until the next good value.
    void set_position_invalid() { position_invalid_ = true; }
    void set_height_invalid(HeightSource source) { height_invalid_[static_cast<std::size_t>(source)] = true; }

    [[nodiscard]] flight::OwnShipEstimate estimate(base::Time now) const;

    static constexpr base::Duration kPairing = base::Duration::milliseconds(60);

private:
    struct Sample {
        double value = 0;
        base::Time at;
        bool unused = false;
    };
    void pair_velocity();
    void add_velocity(AxisFilter& axis, double velocity_mps, base::Time at);
    [[nodiscard]] double latitude() const;
    [[nodiscard]] double metres_per_latitude() const;
    [[nodiscard]] double metres_per_longitude() const;
    [[nodiscard]] std::size_t usable_height(base::Time now) const;

    OwnShipSettings settings_;
    AxisFilter latitude_;
    AxisFilter longitude_;
    std::array<AxisFilter, kHeightSources> heights_;
    Sample ground_speed_;
    Sample true_track_;
    double position_sigma_m_;
    double height_sigma_m_;
    bool position_invalid_ = false;
    std::array<bool, kHeightSources> height_invalid_{};
};
static_assert(std::is_trivially_copyable_v<OwnShipFilter>);

}  // namespace tedavis::bus
