/// Measures effects that are left out because they would be invisible: for each effect, in how many of a flight's pictures that
/// is, the time saved, and whether a difference can be seen.
///
/// Each effect is requested alone, in addition to those of the design, over the same poses twice: as the product draws it, which
/// leaves out invisible effects, and with every effect forced (`replay --force-effects`). Frames of both are drawn alternately,
/// so that a load on the machine slows both.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "host_sim/measure/paired_cost.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/reports/effect_tally.hpp"
#include "render_core/effects/effect_table.hpp"

namespace tedavis::host_sim {

struct EffectUse : EffectCount {
    std::string contribution;              ///< "content", "color" or "geometry"
    effects::PairedCost saved;             ///< of a frame without it; 0 where the noise is greater
    std::uint32_t largest_difference = 0;  ///< of a colour channel, 0..255, over the frames without the effect
    /// Pose of this difference, as `--pose` of `tedavis shot` takes it, and its phase; empty: no difference.
    std::string worst_pose;

    /// Whether leaving the effect out did no work for it and, for an effect on colour, changed no channel by more than one step.
    [[nodiscard]] bool keeps_promise() const;
};

struct UncalledEffects {
    std::string design, device;
    std::uint64_t frames = 0;     ///< poses for each effect
    std::vector<EffectUse> uses;  ///< of the effects that can be requested, in the order of effects::Effect

    [[nodiscard]] bool keep_promise() const;  ///< for all effects
};

struct UncalledPlan {
    std::size_t poses = 8, rounds = 3;
    std::vector<effects::Effect> only;  ///< empty: all
    /// Called before each effect. It may throw.
    std::function<void(std::size_t done, std::size_t total)> progress;
};

/// Measures along `flight`. `options` state terrain, scene, size and device of the pictures. Throws UserError.
[[nodiscard]] UncalledEffects measure_uncalled(const KnobFlight& flight, const PictureOptions& options, const UncalledPlan& plan);

}  // namespace tedavis::host_sim
