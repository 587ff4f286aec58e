/// What lies ahead of a frame's picture: whether terrain does (terrain_ahead.hpp), and what raises the weights of aspects above
/// those that a design states: hazards on the way, and stale data. Decided at the intervals
/// of labels (draw/data/label_planner.hpp) by what they ask for at the interval's first instant, and approached little by little:
/// what is only just reached neither flickers nor leaps.
///
///   follow(instant, source, design) each frame, and at every interval that a replay passes over · above(stated)
///
/// The alert comes at once and stays for kHeldIntervals after the last interval that asked for it, whatever design takes its
/// turn.
///
/// The place of a hazard is that of the interval; it stays while what it raised is still falling. When another of the display's
/// designs takes its turn the interval is decided anew for that one, at its first instant and at once: the fade between both
/// covers it.
///
/// Plain data: a copy is what an interval leaves to the next one.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/base/time.hpp"
#include "render_core/design/priority.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_time.hpp"
#include "render_core/policy/terrain_ahead.hpp"

namespace tedavis::policy {

/// That aspects are weighed by.
struct PriorityInstant {
    base::Time now{0};  ///< the source's
    flight::FlightTime time;
    flight::OwnShipEstimate own_ship;
    flight::FlightPhase phase;
};

struct PriorityBoosts {
    std::array<double, design::kMaxAspects> of{};  ///< 0..1, above the stated weights
    bool has_hazard = false;
    earth::Geodetic hazard;  ///< with it: where the first one is met; height over the ellipsoid
    TerrainAhead terrain_ahead = TerrainAhead::none;
};

/// What is asked for at an instant.
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
    static constexpr double kMaxRise = 0.25, kMaxFall = 0.125;  ///< of a weight, from one interval to the next
    static constexpr std::int64_t kHeldIntervals = 4;           ///< two seconds

    /// `design`: a number for each of the display's designs; `source` answers for that one.
    void follow(const PriorityInstant& instant, BoostSource& source, std::size_t design);
    void forget() { *this = {}; }
    [[nodiscard]] design::AspectWeights above(const design::AspectWeights& stated) const;
    /// Null where there is none.
    [[nodiscard]] const earth::Geodetic* hazard() const { return raises_.has_hazard ? &raises_.hazard : nullptr; }
    [[nodiscard]] TerrainAhead terrain_ahead() const { return raises_.terrain_ahead; }
    /// The interval was decided in one way, and then anew.
    [[nodiscard]] bool is_anew() const { return is_anew_; }

private:
    void approach(const PriorityBoosts& asked, std::int64_t intervals);

    void follow_alert(TerrainAhead asked, std::int64_t intervals);

    PriorityBoosts raises_;
    std::int64_t alert_intervals_left_ = 0;  ///< the alert stays for them without being asked for
    PriorityInstant instant_;                ///< the interval's first
    base::Time last_now_{0};
    flight::OwnShipEstimate last_own_;
    std::size_t design_ = 0;
    bool is_decided_ = false, is_anew_ = false;
};

}  // namespace tedavis::policy
