/// The terrain alert: whether the own ship flies into terrain. The notice TERRAIN AHEAD and the warning colours follow it in
/// every phase and design.
///
/// Terrain is ahead where the predicted track comes closer to the ground than the clearance that the flight phase requires,
/// within a minute, on five parallel lines over a width of 400 m. The phase only sets the clearance; no phase switches the
/// alert off. Where the aircraft is already below the clearance, terrain counts only if the track comes closer by a quarter, so
/// that low flight over level ground gives no alert.
///
/// There is no alert at a ground speed below 15 m/s (taxiing); close to the ground near a runway of the scene; for ground round
/// a runway at the runway's height; and beyond the point where the track reaches the runway. Without a scene with runways, a
/// landing gives an alert. Unknown ground gives no alert: the display shows by other means that it is missing. This is not a
/// certified alerting system.
///
/// Based on  Forward-looking terrain avoidance: required clearances of TSO-C151c table 3.1.1; 60 s and 30 s, and heights near a
///           runway, of Garmin and Honeywell guides (190-00709, 060-4241-000).
/// Bounded   kMaxSteps x kLines places of the track, and kMaxRunways for each that is too close. Pure, but for what the ground
///           reads. Thread  the display's.
#pragma once

#include <cstdint>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/span.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/policy/predicted_track.hpp"

namespace tedavis::scene {
class Ground;
struct Layer;
struct ScenePoint;
}  // namespace tedavis::scene

namespace tedavis::policy {

enum class TerrainAhead : std::uint8_t {
    none,
    caution,  ///< within 60 s
    warning,  ///< within 30 s
};

class TerrainWatch {
public:
    static constexpr double kLookAhead_s = 60, kWarning_s = 30;
    static constexpr double kSlowest_mps = 15;  ///< ground speed; slower aircraft stand or taxi
    static constexpr int kMaxSteps = 256, kLines = 5;
    static constexpr std::size_t kMaxRunways = 32;

    /// All arguments must outlive the object. `layers` are those of the scene, or empty; runways near the track beyond
    /// kMaxRunways count as ground.
    TerrainWatch(const PredictedTrack& track, flight::FlightPhase phase, base::Span<const scene::Layer> layers,
                 scene::Ground& ground);

    [[nodiscard]] TerrainAhead ahead();
    /// Returns the time until the track is too close to the ground, s; infinite where it is not within kLookAhead_s.
    [[nodiscard]] double seconds_to_terrain();

private:
    struct NearRunway {
        double distance_m, height_m;  ///< distance to the nearest point of a runway, and its height above the ellipsoid
    };
    struct RunwayLine {
        const scene::ScenePoint *from, *to;
    };
    void find_runways(base::Span<const scene::Layer> layers);
    [[nodiscard]] bool is_inhibited();
    [[nodiscard]] bool lands(double seconds);
    [[nodiscard]] bool is_too_close(double seconds);
    [[nodiscard]] bool is_ground_of_runway(const earth::Geodetic& place, double ground_m);
    [[nodiscard]] NearRunway nearest_runway(const earth::Geodetic& place);

    const PredictedTrack& track_;
    scene::Ground& ground_;
    base::FixedVector<RunwayLine, kMaxRunways> runways_;  ///< runways that the track can approach
    double height_above_ground_m_;                        ///< height of the own ship; infinite where the ground is unknown
    double clearance_m_;
};

/// Returns the clearance that the phase requires, m; it differs between level flight and a descent of more than 500 ft/min.
[[nodiscard]] double required_clearance_m(flight::FlightPhase phase, double up_mps) noexcept;

}  // namespace tedavis::policy
