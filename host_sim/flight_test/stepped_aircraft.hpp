/// The aircraft of a flight test's steps: it moves as its ground speed, track and vertical speed say, and has the values that the
/// steps hold or ramp.
///
/// Without steps it flies straight on. Attitude, airspeed, altitude and position that no step holds are computed from the motion,
/// in still air of the standard atmosphere.
#pragma once

#include <array>
#include <optional>

#include "host_sim/flight_log/signal_sample.hpp"
#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/geoid_egm96.hpp"

namespace tedavis::host_sim {

class SteppedAircraft {
public:
    explicit SteppedAircraft(const TestStart& start);

    /// Applies the holds and ramps of a step from `time_s` on. A ramp of a direction turns the shorter way; a ramp of a signal
    /// without a value jumps to its end value.
    void take(const TestStep& step, double time_s);
    /// Moves the aircraft to a time, which must not decrease.
    void advance_to(double time_s);
    /// Returns all values, SI, at the time of the last advance_to(); NaN where there is none, as for a radio altimeter out of its
    /// range.
    [[nodiscard]] SignalSample sample() const;

private:
    struct Ramp {
        double from = 0, to = 0, begin_s = 0, over_s = 0;
    };
    static constexpr double kStep_s = 0.02;
    void set_usual_values(const TestStart& start);
    void follow_ramps();
    void move(double seconds);
    void derive(SignalSample& sample) const;
    void put(SignalSample& sample, flight::Signal signal, double value) const;

    double time_s_ = 0;
    double latitude_rad_, longitude_rad_, altitude_msl_m_;
    std::optional<double> ground_msl_m_;
    SignalSample values_;
    std::array<bool, flight::kSignalCount> is_held_{};
    std::array<std::optional<Ramp>, flight::kSignalCount> ramps_{};
    GeoidEgm96 geoid_;
};

}  // namespace tedavis::host_sim
