/// Flies a scenario: a point-mass aircraft with smooth bank, climb and speed, coordinated turns, and wind that grows
/// with height above the strip; integrated in steps of 10 ms, the same on every run.
///
/// Guidance: the track is steered to a heading, a point or the strip's centre line through the bank angle,
/// turn rate = g tan(bank) / airspeed. Attitude follows from the motion: roll is the bank, pitch the flight-path angle
/// plus an angle of attack that falls with the square of the speed, heading the direction of the air path.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host_sim/flight_log/flight_source.hpp"
#include "host_sim/geoid_egm96.hpp"
#include "host_sim/scenario/radio_altimeter.hpp"
#include "host_sim/scenario/scenario.hpp"
#include "host_sim/scenario/scenario_traffic.hpp"

namespace tedavis::host_sim {

/// The atmosphere of one flight: the scenario's values as varied by the seed.
struct FlownAir {
    double qnh_pa = 0, temperature_deviation_k = 0, wind_speed_mps = 0, wind_from_rad = 0;
};

struct AirInstruments;

class ScenarioFlight final : public FlightSource {
public:
    struct State {
        double latitude_rad = 0, longitude_rad = 0, altitude_msl_m = 0;  ///< of the antenna
        double north_mps = 0, east_mps = 0, up_mps = 0;
        double airspeed_mps = 0;
        double heading_rad = 0, pitch_rad = 0, roll_rad = 0;  ///< heading unwrapped
        double wind_share = 0;                                ///< fraction of the free wind, 0 on the ground
    };
    struct FlownLeg {
        double begin_s = 0, end_s = 0;
    };

    /// Throws UserError naming the leg that does not end within its time (15 minutes), or the raster that cannot be read.
    ScenarioFlight(const Scenario& scenario, std::uint64_t seed, const GeoidEgm96& geoid);

    [[nodiscard]] base::Time begin() const override { return scenario_.start; }
    [[nodiscard]] base::Time end() const override;
    [[nodiscard]] std::optional<SignalSample> at(base::Time time) const override;
    [[nodiscard]] std::optional<flight::FlightPhase> stated_phase(base::Time time) const override;

    [[nodiscard]] bool states_guidance() const override { return scenario_.guidance.has_value(); }
    [[nodiscard]] std::vector<ReceivedAircraft> traffic(base::Time time) const override { return traffic_.at(time); }

    [[nodiscard]] const FlownAir& air() const { return air_; }
    /// One for each leg of the scenario, in order.
    [[nodiscard]] const std::vector<FlownLeg>& legs() const { return legs_; }
    /// States 10 ms apart from begin().
    [[nodiscard]] const std::vector<State>& states() const { return states_; }

private:
    struct Wave {
        double amplitude_rad = 0, frequency_radps = 0, phase_rad = 0;
    };

    void draw_random(std::uint64_t seed);
    void add_turbulence();
    [[nodiscard]] State state_at(double time_s) const;
    [[nodiscard]] AirInstruments instruments_of_air() const;
    void add_air_data(const State& state, SignalSample& sample) const;
    void add_radio_height(const State& state, SignalSample& sample) const;
    void add_motion(double time_s, const State& state, SignalSample& sample) const;

    Scenario scenario_;
    const GeoidEgm96& geoid_;
    ScenarioTraffic traffic_;
    std::optional<RadioAltimeter> radio_altimeter_;
    FlownAir air_;
    std::vector<Wave> roll_waves_, pitch_waves_;
    std::vector<State> states_;
    std::vector<FlownLeg> legs_;
};

inline constexpr double kScenarioStep_s = 0.01;
inline constexpr double kStepsPerSecond = 100;  ///< divides exactly where a multiple of 0.01 would not

}  // namespace tedavis::host_sim
