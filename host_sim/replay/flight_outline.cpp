#include "host_sim/replay/flight_outline.hpp"

namespace tedavis::host_sim {

void FlightOutline::add_place(const flight::OwnShipEstimate& own_ship, base::Time time) {
    if (own_ship.state != base::SignalState::valid) return;
    if (places_.size() >= kMaxPlaces) {
        for (std::size_t n = 1; 2 * n < places_.size(); ++n) places_[n] = places_[2 * n];
        places_.resize(places_.size() / 2);
        stride_ *= 2;
    }
    places_.push_back({time, own_ship.position.latitude_rad, own_ship.position.longitude_rad});
}

void FlightOutline::add_phase(const flight::FlightPhase& presented, base::Time time) {
    if (has_phase_ && !(presented == phase_) && changes_.size() < kMaxChanges) changes_.push_back(time);
    phase_ = presented;
    has_phase_ = true;
}

}  // namespace tedavis::host_sim
