/// A generated ensemble forecast of gusts near the ground round the strip: the layer "gusts", for the start and the two hours
/// after it. Possible distributions of gusts are in the members alone; their mean and spread are the attribute's values and
/// uncertainty.
///
/// Member m at the distance d from the strip and the time t is
///     max(0, kGustFactor * wind speed + sigma * (kAlike * o_m + sqrt(1 - kAlike^2) * w_m)),
///     sigma = gust_spread_mps * (1 + d / kGustDistance_m + t / 1 h)
/// with a random offset o_m of the whole member and smooth random waves w_m that drift with the wind; each has the mean 0 and the
/// variance 1. The members are in the order of their means, as those of a scene file (scene_builder/ensemble.hpp). The attribute
/// is "gust" (m/s); kFullGustSpread_mps is level 1 of its uncertainty.
#pragma once

#include "host_sim/scenario/scenario.hpp"
#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

inline constexpr std::uint32_t kGustPosts = 16;
inline constexpr int kGustTimes = 3;  ///< an hour apart
inline constexpr double kGustFactor = 1.5;
inline constexpr double kAlike = 0.6;
inline constexpr double kGustDistance_m = 15'000;
inline constexpr double kFullGustSpread_mps = 5;

/// The scenario must have weather with two members or more.
[[nodiscard]] LayerDraft make_gust_layer(const Scenario& scenario, const FlownAir& air, SeededRandom& random);

}  // namespace tedavis::host_sim
