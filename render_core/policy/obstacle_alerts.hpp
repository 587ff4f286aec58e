/// The obstacles that the predicted track comes too close to, and when: what the obstacle alert states and colours
/// (obstacle_ahead.hpp decides it). Plain data; pure functions; any thread.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/policy/terrain_alert_zone.hpp"

namespace tedavis::policy {

struct AlertedObstacle {
    static constexpr std::uint16_t kStraightAhead = 0x8000;

    std::uint32_t feature = 0;
    std::uint16_t layer = 0;   ///< its number in the scene
    std::uint16_t tenths = 0;  ///< of a second until it is reached, rounded down; kStraightAhead: on the straight track in a turn

    [[nodiscard]] bool is_straight_ahead() const { return (tenths & kStraightAhead) != 0; }
    [[nodiscard]] double seconds() const { return (tenths & ~kStraightAhead) / 10.0; }
    [[nodiscard]] double counted_s() const { return (is_straight_ahead() ? 2 : 1) * seconds(); }
    [[nodiscard]] TerrainAhead level() const {
        return counted_s() <= kTerrainWarning_s ? TerrainAhead::warning : TerrainAhead::caution;
    }
};
static_assert(sizeof(AlertedObstacle) == 8, "planner memories hold many");

class ObstacleAlerts {
public:
    /// The number of obstacles, those reached first, that are coloured; the level counts all.
    static constexpr std::size_t kMax = 48;

    /// Adds an obstacle with the times until the predicted track and the straight one reach it, infinite where they do not.
    /// Ignores obstacles whose counted time is more than kTerrainCaution_s.
    void add(std::uint16_t layer, std::uint32_t feature, double on_track_s, double straight_s);

    [[nodiscard]] TerrainAhead level() const;
    /// Returns the level of an obstacle; `none` where it is not in the way.
    [[nodiscard]] TerrainAhead of(std::uint16_t layer, std::uint32_t feature) const;
    /// Returns the counted time of the first obstacle; infinite without an alert.
    [[nodiscard]] double soonest_s() const {
        return all_.empty() ? std::numeric_limits<double>::infinity() : all_[0].counted_s();
    }
    /// Returns the obstacles in the order of their counted times.
    [[nodiscard]] const base::FixedVector<AlertedObstacle, kMax>& all() const { return all_; }
    /// Returns the number of all obstacles in the way, also of those that are not coloured.
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// Returns a number that changes when the level of any obstacle changes, and with it the picture. 0: there is none.
    [[nodiscard]] std::uint64_t key() const;

private:
    base::FixedVector<AlertedObstacle, kMax> all_;
    std::uint32_t count_ = 0;
};
static_assert(std::is_trivially_copyable_v<ObstacleAlerts>);

}  // namespace tedavis::policy
