#include "render_core/policy/priority_boost.hpp"

#include <algorithm>

#include "render_core/flight/decision_interval.hpp"

namespace tedavis::policy {
namespace {

bool is_same_flight(const flight::OwnShipEstimate& a, const flight::OwnShipEstimate& b) {
    return a.state == b.state && a.position.latitude_rad == b.position.latitude_rad &&
           a.position.longitude_rad == b.position.longitude_rad && a.position.height.m == b.position.height.m &&
           a.velocity_north_mps == b.velocity_north_mps && a.velocity_east_mps == b.velocity_east_mps &&
           a.velocity_up_mps == b.velocity_up_mps;
}

}  // namespace

void PriorityBoost::follow(const PriorityInstant& instant, BoostSource& source, std::size_t design) {
    // The same instant at another position is not a continuous flight.
    const bool leaps = is_decided_ && instant.now == last_now_ && !is_same_flight(instant.own_ship, last_own_);
    last_now_ = instant.now;
    last_own_ = instant.own_ship;
    if (is_decided_ && !leaps && design != design_) {
        const PriorityBoosts before = raises_;
        raises_ = source.boosts_at(instant_);
        raises_.terrain_ahead = before.terrain_ahead;
        raises_.obstacles = before.obstacles;
    }
    design_ = design;
    const std::int64_t interval = flight::decision_interval_of(instant.now);
    const std::int64_t passed = interval - flight::decision_interval_of(instant_.now);
    if (is_decided_ && passed == 0 && !leaps) return;
    const PriorityBoosts asked = source.boosts_at(instant);
    const bool begins = !is_decided_ || leaps || passed < 0;
    if (begins)
        raises_ = asked;
    else
        approach(asked, passed);
    follow_alerts(asked, begins ? kHeldIntervals : passed);
    instant_ = instant;
    is_decided_ = true;
}

void PriorityBoost::approach(const PriorityBoosts& asked, std::int64_t intervals) {
    bool is_falling = false;
    for (std::size_t n = 0; n < raises_.of.size(); ++n) {
        double& raise = raises_.of[n];
        const auto steps = static_cast<double>(intervals);
        raise = std::min(std::max(asked.of[n], raise - steps * kMaxFall), raise + steps * kMaxRise);
        is_falling = is_falling || (n != design::kUncertaintyAspect && raise > 0);
    }
    if (!asked.has_hazard && is_falling) return;
    raises_.has_hazard = asked.has_hazard;
    raises_.hazard = asked.hazard;
}

void PriorityBoost::follow_alerts(const PriorityBoosts& asked, std::int64_t intervals) {
    raises_.terrain_watch = asked.terrain_watch;
    const auto holds = [intervals](TerrainAhead level, std::int64_t& left) {
        left = level != TerrainAhead::none ? kHeldIntervals : std::max<std::int64_t>(left - intervals, 0);
        return level == TerrainAhead::none && left > 0;
    };
    if (!holds(asked.terrain_ahead, terrain_intervals_left_)) raises_.terrain_ahead = asked.terrain_ahead;
    if (!holds(asked.obstacles.level(), obstacle_intervals_left_)) raises_.obstacles = asked.obstacles;
}

design::AspectWeights PriorityBoost::above(const design::AspectWeights& stated) const {
    design::AspectWeights weights = stated;
    for (std::size_t n = 0; n < weights.of.size(); ++n) weights.of[n] = std::min(weights.of[n] + raises_.of[n], 1.0);
    return weights;
}

}  // namespace tedavis::policy
