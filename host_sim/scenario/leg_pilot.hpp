/// Flies the legs: computes the targets of bank, climb and speed from the aircraft's state, and the end of a leg.
#pragma once

#include "host_sim/scenario/scenario.hpp"
#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/scenario/smoothed_value.hpp"

namespace tedavis::host_sim {

class LegPilot {
public:
    LegPilot(const Scenario& scenario, const FlownAir& air);

    /// The current state; at first the aircraft stands at the strip's beginning.
    [[nodiscard]] const ScenarioFlight::State& state() const { return state_; }
    void begin(const Leg& leg);
    /// Advances by kScenarioStep_s; returns true when the leg has ended.
    [[nodiscard]] bool step(const Leg& leg);

private:
    /// Along the strip's heading from its centre, and to the right of it, metres.
    struct StripCoordinates {
        double along_m = 0, right_m = 0;
    };
    [[nodiscard]] StripCoordinates on_strip() const;
    [[nodiscard]] double wheels_above_strip_m() const;
    [[nodiscard]] double track_rad() const;
    [[nodiscard]] double course(const Leg& leg) const;
    [[nodiscard]] double vertical_target_mps(const Leg& leg) const;
    [[nodiscard]] double glide_vertical_mps(const Leg& leg) const;
    [[nodiscard]] bool ended(const Leg& leg) const;
    void fly(const Leg& leg);
    void roll_on_ground(double acceleration_mps2);
    void move();

    const Scenario& scenario_;
    FlownAir air_;
    ScenarioFlight::State state_;
    SmoothedValue bank_, climb_, pitch_, thrust_;
    double leg_time_s_ = 0;
    double vertical_acceleration_mps2_ = 0;
    bool airborne_ = false, stopped_ = false;
};

}  // namespace tedavis::host_sim
