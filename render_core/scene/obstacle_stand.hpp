/// Where an obstacle begins and ends above the ellipsoid: the same for its picture and for the obstacle alert.
///
/// A point's top is its height in the layer's datum; a point without height stands its "height" over the ground. The foot is the
/// ground, or where that is not known or higher than the top, "height" below the top. What does not state its height is as high
/// as the caller says. Pure, but for what the ground reads.
#pragma once

#include "render_core/scene/ground.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

/// Height of an obstacle, and of a cable's pole, that does not state it.
inline constexpr double kUnknownObstacle_m = 100, kPole_m = 20;

struct ObstacleStand {
    double foot_m = 0, top_m = 0;  ///< NaN where the ground that they refer to is unknown
    bool is_stated = true;         ///< its height is

    [[nodiscard]] bool is_known() const { return top_m > foot_m; }
    [[nodiscard]] double height_m() const { return top_m - foot_m; }
};
/// `height_m`: the feature's "height", or NaN.
[[nodiscard]] ObstacleStand obstacle_stand(const Layer& layer, const ScenePoint& point, double height_m, double unknown_m,
                                           Ground& ground);

/// By how much places and tops may be off, 95 %, m; 0: not stated. Of the feature's attributes "position_accuracy" or "position"
/// and "height_accuracy", else of the layer; and no less than the uncertainty of its "height".
struct ObstacleAccuracy {
    double level_m = 0, height_m = 0;
};
[[nodiscard]] ObstacleAccuracy obstacle_accuracy(const Layer& layer, std::uint32_t feature);

}  // namespace tedavis::scene
