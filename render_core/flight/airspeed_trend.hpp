/// How fast the airspeed changes, for the trend beside the airspeed tape.
///
/// Differences of successive samples, divided by their source times, smoothed by a first-order filter with a time constant of
/// kSmoothing: exact for a steady change. Samples are told apart by their source time, so the result does not depend on how
/// often step() is called. Plain data; a copy is a checkpoint. Thread one.
#pragma once

#include <type_traits>

#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::flight {

class AirspeedTrend {
public:
    static constexpr base::Duration kSmoothing = base::Duration::seconds(1);
    static constexpr base::Duration kMaxGap = base::Duration::seconds(1);  ///< between two samples; a longer one begins anew
    static constexpr double kMaxChange_mps2 =
        10;  ///< between two samples; a greater one is another sensor's value, and begins anew
    static constexpr base::Duration kSettling = base::Duration::seconds(2);  ///< of samples before a rate is stated

    /// Takes the indicated airspeed, or the calibrated one where that is not valid, when it is new.
    void step(const AircraftState& aircraft, base::Time now);
    /// Returns m/s^2, stamped with the latest sample; missing until it has settled.
    [[nodiscard]] base::Stamped<double> rate() const;

private:
    void begin(Signal source, const base::Stamped<double>& sample);

    Signal source_ = Signal::count_;  // count_: no samples
    base::Stamped<double> last_;
    base::Time begun_;
    double rate_mps2_ = 0;
};
static_assert(std::is_trivially_copyable_v<AirspeedTrend>);

}  // namespace tedavis::flight
