/// Which hazards lie on the way: terrain, and features of the data that may raise the weight of their aspect
/// (design/priority.hpp).
///
/// The way is straight ahead at the speed of the instant, for `hazard_ahead_s`. A hazard counts from 0 at its end to 1 at half of
/// it, in eighths, by the time until the aircraft is within `hazard_within_m` of it aside, and a third of that above or below;
/// terrain is looked at four times as often, on five lines along the way. A function of the instant alone: what is only just
/// reached comes and goes (priority_boost.hpp steadies it). Heights and floors that are not stated count as if they were at the
/// aircraft's own height; ground that is not known does not count, and is said otherwise.
///
/// Bounded: kSteps places of the way, and every point of the layers. Thread  the display's.
#pragma once

#include <array>
#include <limits>

#include "render_core/design/priority.hpp"
#include "render_core/policy/predicted_track.hpp"
#include "render_core/scene/ground.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::policy {

/// Shares 0..1 by aspect; 0 of those that are no hazard.
using HazardShares = std::array<double, design::kMaxAspects>;

class HazardWatch {
public:
    static constexpr int kSteps = 24;
    /// All must stay while it is asked. `time_ns`: the frame's, for what moves.
    HazardWatch(const design::PrioritySettings& settings, const PredictedTrack& track, scene::Ground& ground,
                std::int64_t time_ns);

    [[nodiscard]] double terrain_share();
    [[nodiscard]] double layer_share(const scene::Layer& layer);
    /// Until the way comes within reach of a feature, at its height; infinite where it does not.
    [[nodiscard]] double seconds_to(const scene::Layer& layer, std::uint32_t feature);
    /// Of all that was asked for: where on the way the first hazard is met. False where there was none.
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
    double metres_per_latitude_, metres_per_longitude_;  ///< a radian's
};

}  // namespace tedavis::policy
