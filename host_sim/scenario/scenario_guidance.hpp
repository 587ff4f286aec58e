/// The pilot's selections and the receivers' signals of a generated flight, derived from the scenario's legs and the flown
/// states, so that the guidance always leads along the flight.
///
/// On legs to a point the navigation source is GNSS, on final and landing the first radio receiver, until the touchdown zone is
/// reached; otherwise there is none. The localizer is kLocalizerBeyond_m beyond the strip's far end, the glide path begins at the
/// touchdown zone. The flight director commands the attitude that is flown kDirectorLead_s later.
#pragma once

#include <vector>

#include "host_sim/scenario/scenario_flight.hpp"

namespace tedavis::host_sim {

inline constexpr double kLocalizerBeyond_m = 300;
inline constexpr double kDirectorLead_s = 1.5;

/// Converts true altitudes to indicated ones, and true airspeeds to calibrated ones, in the atmosphere of one flight.
struct AirInstruments {
    double field_msl_m = 0, qnh_pa = 0, temperature_deviation_k = 0;

    /// Indicated altitude, m; exact at the field's elevation.
    [[nodiscard]] double baro_altitude_m(double altitude_msl_m) const;
    [[nodiscard]] double outside_temperature_k(double altitude_msl_m) const;
    /// Ratio of calibrated to true airspeed, for speeds far below that of sound.
    [[nodiscard]] double airspeed_ratio(double altitude_msl_m) const;
};

class ScenarioGuidance {
public:
    /// `scenario` must have guidance; the flight must outlive this object.
    ScenarioGuidance(const Scenario& scenario, const ScenarioFlight& flight, const AirInstruments& instruments)
        : scenario_(scenario), guidance_(*scenario.guidance), flight_(flight), instruments_(instruments) {}

    /// Adds the guidance at `time_s` after the flight's begin; values that are not selected stay absent.
    void add(double time_s, SignalSample& sample) const;

private:
    struct FromStrip {
        double along_m = 0, right_m = 0;  ///< along the strip's heading from its middle, and to the right of it
    };
    [[nodiscard]] flight::NavigationSource source_on(const Leg& leg, const ScenarioFlight::State& state) const;
    [[nodiscard]] double to_touchdown_zone_m(const ScenarioFlight::State& state) const;
    [[nodiscard]] std::size_t leg_at(double time_s) const;
    [[nodiscard]] const ScenarioFlight::State& state_near(double time_s) const;
    [[nodiscard]] FromStrip from_strip(const ScenarioFlight::State& state) const;
    [[nodiscard]] double flaps_position(double time_s) const;
    void add_selected(std::size_t leg, SignalSample& sample) const;
    void add_landing_aids(const ScenarioFlight::State& state, SignalSample& sample) const;
    void add_route(std::size_t leg, const ScenarioFlight::State& state, SignalSample& sample) const;
    void add_director(double time_s, SignalSample& sample) const;

    const Scenario& scenario_;
    const Guidance& guidance_;
    const ScenarioFlight& flight_;
    AirInstruments instruments_;
};

}  // namespace tedavis::host_sim
