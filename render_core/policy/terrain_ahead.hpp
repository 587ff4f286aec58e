/// The terrain alert: whether the own ship flies into terrain. The notice TERRAIN AHEAD follows it in every phase and design, and
/// so does the colour of the ground that is too close (terrain_alert_zone.hpp).
///
/// Terrain is ahead where the predicted track comes closer to the ground than the clearance that the flight phase requires,
/// within a minute. The track keeps its vertical speed, its speed and its rate of turn, the last for half a turn at most, where
/// the track ends, sooner than after a minute. A turn may end at any time: the planner also watches the straight track, whose
/// times count twice (counted_s). A track is widened by the uncertainty of all of these (TrackUncertainty), and what is below it
/// counts with its proven upper bound: no true track within that uncertainty comes too close to the ground without an alert.
/// Bounds are of whole blocks of the terrain, or of whole chunks where these are many or cannot be read, so that an alert may
/// also come for ground beside the widened track. The phase only sets the clearance; no phase switches the alert off.
///
/// Low flight: clearance and uncertainty together take no more than three quarters of the height above the ground at present, so
/// that level flight over level ground gives no alert; both are reduced by the same factor.
///
/// A track that reaches a runway needs the clearance of the final approach, in every phase.
/// There is no alert at a ground speed below 15 m/s (taxiing); close to the ground near a runway of the scene; for ground round
/// a runway at the runway's height; and beyond the point where the track reaches the runway. Without a scene with runways, a
/// landing gives an alert. Unknown ground gives no alert: the display shows by other means that it is missing. This is not a
/// certified alerting system.
///
/// Based on  Forward-looking terrain avoidance: required clearances of TSO-C151c table 3.1.1; 60 s and 30 s, and heights near a
///           runway, of Garmin and Honeywell guides (190-00709, 060-4241-000). Width: two velocities that differ by dv in speed
///           and at most a in direction differ by at most dv + v a, whose integral is the distance of the places.
/// Range     places err by the square of the distance times the tangent of the latitude over two Earth radii (12 m in 12 km at 47
///           degrees), which the uncertainty of the position does not count.
/// Bounded   twice kMaxSteps places of the track, and kMaxRunways for each that is too close. Pure, except for queries of the
///           grounds.
/// Thread    the display's.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/span.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/policy/ground_bound.hpp"
#include "render_core/policy/predicted_track.hpp"
#include "render_core/policy/terrain_alert_zone.hpp"

namespace tedavis::scene {
class Ground;
struct Layer;
struct ScenePoint;
}  // namespace tedavis::scene

namespace tedavis::policy {

/// A smaller uncertainty that a receiver states is replaced by this one.
inline constexpr double kMinPositionUncertainty_m = 10;

/// By how much the true track may differ from the predicted one. Rates are this display's own; positions are stated or assumed.
struct TrackUncertainty {
    double position_m = 50;  ///< horizontally
    double height_m = 20;    ///< of the own ship above the drawn terrain
    double speed_mps = 1;
    double direction_rad = 0.0175;  ///< one degree
    double turn_radps = 0.00175;    ///< a tenth of a degree a second
    double climb_mps = 0.3;
};

struct TerrainWatchInput {
    PredictedTrack track;
    TrackUncertainty uncertainty;
    flight::FlightPhase phase;
    /// Layers of the scene, or empty; they must stay valid. Runways near the track beyond kMaxRunways count as ground.
    base::Span<const scene::Layer> layers;
};

/// The track between two times: a disc that contains all true tracks, and the height above which ground and obstacles in it are
/// too close.
struct TrackStep {
    double from_s = 0, to_s = 0;
    double north_m = 0, east_m = 0;  ///< of the own ship
    double radius_m = 0;
    double floor_m = 0;  ///< above the ellipsoid
};
inline constexpr std::size_t kMaxTrackSteps = 256;
using TrackSteps = base::FixedVector<TrackStep, kMaxTrackSteps>;

/// Returns the time by which an alert is judged where the predicted track turns, s: that on it, or twice that on the straight
/// track if this is less. An aircraft that circles in a valley has terrain straight ahead all the time and turns away from it.
/// Since the turn may end, this terrain is a caution within 30 s and a warning within 15 s.
[[nodiscard]] double counted_s(double on_track_s, double straight_s) noexcept;
[[nodiscard]] TerrainAhead level_within(double seconds) noexcept;

class TerrainWatch {
public:
    static constexpr double kLookAhead_s = kTerrainCaution_s;
    static constexpr double kSlowest_mps = 15;  ///< ground speed; slower aircraft stand or taxi
    static constexpr int kMaxSteps = kMaxTrackSteps;
    static constexpr std::size_t kMaxRunways = 32;
    /// The zone that is shown is so much wider than the track's uncertainty, and lower by what a moving floor rises or falls on
    /// the way through it: an alert colours the ground that caused it, and a little more. Where the bound of a coarser block or
    /// of a whole chunk caused it, that ground may lie outside of the zone.
    static constexpr double kShownMargin_m = 200;

    /// Both grounds must outlive the object.
    TerrainWatch(const TerrainWatchInput& input, scene::Ground& ground, GroundBound& bound);

    [[nodiscard]] TerrainAhead ahead() { return level_within(seconds_to_terrain()); }
    /// Returns the time until the track is too close to the ground, s; infinite where it is not within kLookAhead_s.
    [[nodiscard]] double seconds_to_terrain();
    /// Returns the zone that an alert colours.
    [[nodiscard]] TerrainAlertZone zone(TerrainAhead alert);

    [[nodiscard]] const PredictedTrack& track() const { return track_; }
    /// Returns the steps of the track until its end, at a runway or after half a turn; none for aircraft that stand or taxi. Near
    /// a runway the floor is at least a quarter of the track's height above the runway.
    [[nodiscard]] TrackSteps steps();
    /// Returns false where the alert is inhibited, and on a runway.
    [[nodiscard]] bool is_watching();
    /// Height above the ground that the track must keep, m: of the phase, or less in low flight.
    [[nodiscard]] double clearance_m() const { return clearance_m_; }

private:
    struct NearRunway {
        double distance_m, height_m;  ///< of the nearest point of a runway; above the ellipsoid, -infinity where it is far away
        earth::Geodetic place;
    };
    struct RunwayLine {
        const scene::ScenePoint *from, *to;
    };
    void find_runways(base::Span<const scene::Layer> layers);
    [[nodiscard]] bool is_inhibited();
    [[nodiscard]] double step_s(double seconds) const;
    [[nodiscard]] TrackStep step_between(double from_s, double to_s) const;
    [[nodiscard]] double seconds_to_landing();
    [[nodiscard]] bool lands(double seconds);
    [[nodiscard]] double floor_near_runway(const TrackStep& step);
    [[nodiscard]] bool is_too_close(const TrackStep& step);
    [[nodiscard]] NearRunway nearest_runway(const earth::Geodetic& place);
    /// Heights above the ellipsoid.
    [[nodiscard]] double floor_at(double seconds) const { return floor_m_ + floor_mps_ * seconds; }
    [[nodiscard]] double radius_at(double seconds) const { return radius_m_ + (radius_mps_ + radius_mps2_ * seconds) * seconds; }

    const PredictedTrack track_;
    scene::Ground& ground_;
    GroundBound& bound_;
    base::FixedVector<RunwayLine, kMaxRunways> runways_;  ///< runways that the track can approach
    double height_above_ground_m_;                        ///< height of the own ship; infinite where the ground is unknown
    double radius_m_, radius_mps_, radius_mps2_;
    double floor_m_ = 0, floor_mps_ = 0, clearance_m_ = 0;
    double until_s_;  ///< where the track ends
};

/// Returns the clearance that the phase requires, m; it differs between level flight and a descent of more than 500 ft/min.
[[nodiscard]] double required_clearance_m(flight::FlightPhase phase, double up_mps) noexcept;

}  // namespace tedavis::policy
