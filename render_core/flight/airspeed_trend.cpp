#include "render_core/flight/airspeed_trend.hpp"

#include <cmath>

namespace tedavis::flight {

void AirspeedTrend::step(const AircraftState& aircraft, base::Time now) {
    const Signal source = aircraft.is_valid(Signal::indicated_airspeed, now)    ? Signal::indicated_airspeed
                          : aircraft.is_valid(Signal::calibrated_airspeed, now) ? Signal::calibrated_airspeed
                                                                                : Signal::count_;
    if (source == Signal::count_) {
        *this = {};
        return;
    }
    const base::Stamped<double>& sample = aircraft[source];
    const base::Duration gap = sample.source_time() - last_.source_time();
    if (source != source_ || gap > kMaxGap || gap < base::Duration{}) return begin(source, sample);
    if (gap == base::Duration{}) return;
    const double change_mps2 = (sample.value_or(0) - last_.value_or(0)) / gap.to_seconds();
    if (!(std::fabs(change_mps2) <= kMaxChange_mps2)) return begin(source, sample);
    const double share = gap.to_seconds() / (kSmoothing.to_seconds() + gap.to_seconds());
    rate_mps2_ += share * (change_mps2 - rate_mps2_);
    last_ = sample;
}

void AirspeedTrend::begin(Signal source, const base::Stamped<double>& sample) {
    source_ = source;
    last_ = sample;
    begun_ = sample.source_time();
    rate_mps2_ = 0;
}

base::Stamped<double> AirspeedTrend::rate() const {
    if (source_ == Signal::count_ || last_.source_time() - begun_ < kSettling) return {};
    return {rate_mps2_, last_.source_time(), last_.quality()};
}

}  // namespace tedavis::flight
