/// Finds hazards on the predicted track: terrain, and features of the data that may raise the weight of their aspect
/// (design/priority.hpp).
///
/// The track is straight, at the current velocity, for `hazard_ahead_s`. A hazard's share rises from 0 at the end of the track
/// to 1 at half of it, in eighths, by the time until the aircraft is within `hazard_within_m` of it laterally and a third of
/// that vertically. Terrain is sampled four times as densely, on five lines along the track. The result depends on the current
/// instant alone, so a hazard at the limit may come and go (priority_boost.hpp filters that). Heights and floors that are not
/// stated count as the aircraft's own height; unknown ground does not count, and is shown by other means.
///
/// Bounded: kSteps points of the track, and every point of the layers. Thread  the display's.
#pragma once

#include <array>
#include <limits>

#include "render_core/design/priority.hpp"
#include "render_core/policy/predicted_track.hpp"
#include "render_core/scene/ground.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::policy {

/// Shares 0..1 by aspect; 0 for aspects without a hazard.
using HazardShares = std::array<double, design::kMaxAspects>;

class HazardWatch {
public:
    static constexpr int kSteps = 24;
    /// All arguments must outlive the object. `time_ns` is the frame's time, for moving features.
    HazardWatch(const design::PrioritySettings& settings, const PredictedTrack& track, scene::Ground& ground,
                std::int64_t time_ns);

    [[nodiscard]] double terrain_share();
    [[nodiscard]] double layer_share(const scene::Layer& layer);
    /// Returns the share of a hazard that another watch (obstacle_ahead.hpp) expects at a time.
    [[nodiscard]] double share_at(double seconds) { return note(seconds); }
    /// Returns the time until the track comes within reach of a feature, at its height, s; infinite where it does not.
    [[nodiscard]] double seconds_to(const scene::Layer& layer, std::uint32_t feature);
    /// Writes the point of the track where the first of the hazards queried so far is reached. Returns false where there was
    /// none.
    [[nodiscard]] bool first_met(earth::Geodetic& place) const;

private:
    struct Place {
        double east_m, north_m;
    };
    [[nodiscard]] double time_of(int step) const { return settings_.hazard_ahead_s * step / kSteps; }
    [[nodiscard]] Place track_at(double seconds) const { return {track_.east_mps * seconds, track_.north_mps * seconds}; }
    [[nodiscard]] Place place_of(const scene::ScenePoint& point) const;
    [[nodiscard]] double reach_m() const;
    [[nodiscard]] bool is_aside(const scene::Layer& layer, scene::Run run, Place drift) const;
    [[nodiscard]] double clearance_m() const { return settings_.hazard_within_m / 3; }
    [[nodiscard]] double share_of(double seconds) const;
    double note(double seconds);
    [[nodiscard]] bool is_at_terrain(double seconds);
    [[nodiscard]] bool is_near(const scene::Layer& layer, scene::Run run, Place drift, double seconds) const;
    [[nodiscard]] bool is_at_height(const scene::Layer& layer, std::uint32_t feature, double seconds);
    [[nodiscard]] double over_ellipsoid_m(double height_m, scene::HeightDatum datum, const earth::Geodetic& at);

    const design::PrioritySettings& settings_;
    const PredictedTrack& track_;
    scene::Ground& ground_;
    std::int64_t time_ns_;
    double soonest_s_ = std::numeric_limits<double>::infinity();
    double metres_per_latitude_, metres_per_longitude_;  ///< metres per radian
};

}  // namespace tedavis::policy
