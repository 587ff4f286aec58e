/// The alerts of terrain and obstacles (terrain_ahead.hpp, obstacle_ahead.hpp), and the priority boost: hazards ahead and stale
/// data raise the weights of aspects above those that a design states. The target is determined once for each decision interval
/// (flight/decision_interval.hpp), at its first instant, and the weights approach it in limited steps, so that they neither
/// flicker nor jump.
///
///   follow(instant, source, design) each frame, and at every interval that a replay passes over · above(stated)
///
/// An alert is raised at once and stays for kHeldIntervals after the last interval that requested it, also when the phase's
/// design changes; with the obstacles that it last named.
///
/// The position of a hazard is determined once per interval; it is kept while the weight that it raised still falls. When the
/// phase's design changes, the interval is decided again for the new design, at its first instant and without limited steps:
/// the fade between both designs hides the jump.
///
/// Plain data: a copy is the state that one interval passes to the next.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/base/time.hpp"
#include "render_core/design/priority.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_time.hpp"
#include "render_core/policy/obstacle_alerts.hpp"
#include "render_core/policy/terrain_ahead.hpp"

namespace tedavis::policy {

/// The instant for which priorities are determined.
struct PriorityInstant {
    base::Time now{0};  ///< the source's
    flight::FlightTime time;
    flight::OwnShipEstimate own_ship;
    flight::FlightPhase phase;
    double turn_radps = 0;  ///< of the track, to the right
    TrackUncertainty uncertainty;
};

/// The state of the terrain alert's watch, whether there is an alert or not.
struct TerrainWatchState {
    bool is_watching = false;  ///< false: inhibited, on a runway, or not judged
    double clearance_m = 0;    ///< TerrainWatch::clearance_m()
};

struct PriorityBoosts {
    std::array<double, design::kMaxAspects> of{};  ///< 0..1, above the stated weights
    bool has_hazard = false;
    earth::Geodetic hazard;  ///< valid with has_hazard: where the track reaches the first hazard; height above the ellipsoid
    TerrainAhead terrain_ahead = TerrainAhead::none;
    ObstacleAlerts obstacles;
    TerrainWatchState terrain_watch;
};

/// Port: the boosts requested at an instant.
class BoostSource {
public:
    virtual ~BoostSource() = default;
    [[nodiscard]] virtual PriorityBoosts boosts_at(const PriorityInstant& instant) = 0;

protected:
    BoostSource() = default;
    BoostSource(const BoostSource&) = default;
    BoostSource& operator=(const BoostSource&) = default;
};

class PriorityBoost {
public:
    static constexpr double kMaxRise = 0.25, kMaxFall = 0.125;  ///< largest change of a weight from one interval to the next
    static constexpr std::int64_t kHeldIntervals = 4;           ///< two seconds

    /// Updates the boost. `design` is the index of the display's current design; `source` answers for that design.
    void follow(const PriorityInstant& instant, BoostSource& source, std::size_t design);
    void forget() { *this = {}; }
    [[nodiscard]] design::AspectWeights above(const design::AspectWeights& stated) const;
    /// Position of the hazard, or null.
    [[nodiscard]] const earth::Geodetic* hazard() const { return raises_.has_hazard ? &raises_.hazard : nullptr; }
    [[nodiscard]] TerrainAhead terrain_ahead() const { return raises_.terrain_ahead; }
    [[nodiscard]] const ObstacleAlerts& obstacles() const { return raises_.obstacles; }
    [[nodiscard]] const TerrainWatchState& terrain_watch() const { return raises_.terrain_watch; }
    /// To be called when the scene is replaced: the next interval finds the obstacles of the new one.
    void forget_obstacles() { raises_.obstacles = {}; }

private:
    void approach(const PriorityBoosts& asked, std::int64_t intervals);

    void follow_alerts(const PriorityBoosts& asked, std::int64_t intervals);

    PriorityBoosts raises_;
    /// Intervals for which an alert still stays without a request.
    std::int64_t terrain_intervals_left_ = 0, obstacle_intervals_left_ = 0;
    PriorityInstant instant_;  ///< the interval's first
    base::Time last_now_{0};
    flight::OwnShipEstimate last_own_;
    std::size_t design_ = 0;
    bool is_decided_ = false;
};

}  // namespace tedavis::policy
