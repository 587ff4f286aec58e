/// What the scene did not call for: for each effect, how often a flight's pictures went without it, what that saved, and whether
/// it can be seen.
///
/// Each effect is asked for by itself, in addition to those of the design, over the same poses twice: as the product draws it,
/// where an effect that cannot be seen is left out, and with every effect forced (`replay --force-effects`). Frames of both are
/// drawn in turn, so that a load on the machine slows both.
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
    std::uint32_t largest_difference = 0;  ///< of a colour channel, of 255, over the frames that skipped it
    std::string worst_pose;                ///< where it is, as `--pose` of `tedavis shot` takes it, and its phase; empty: nowhere

    /// The picture keeps to what the product promises: no work, and a colour's effect changes no channel by more than one step.
    [[nodiscard]] bool keeps_promise() const;
};

struct UncalledEffects {
    std::string design, device;
    std::uint64_t frames = 0;     ///< poses for each effect
    std::vector<EffectUse> uses;  ///< of the effects that can be asked for, in the order of effects::Effect

    [[nodiscard]] bool keep_promise() const;  ///< all of them
};

struct UncalledPlan {
    std::size_t poses = 8, rounds = 3;
    std::vector<effects::Effect> only;  ///< empty: all
    /// Called before each effect. It may throw.
    std::function<void(std::size_t done, std::size_t total)> progress;
};

/// `options` says terrain, scene, size and device of the pictures.
[[nodiscard]] UncalledEffects measure_uncalled(const KnobFlight& flight, const PictureOptions& options, const UncalledPlan& plan);

}  // namespace tedavis::host_sim
