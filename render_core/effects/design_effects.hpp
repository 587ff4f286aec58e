/// Which effects a design asks for, the design with one more or one less of them, and the design as a device can show it; by the
/// rows of effect_table.cpp. Pure; any thread.
#pragma once

#include "render_core/effects/device.hpp"
#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {

/// Effects that a design asks for, whether or not they are possible.
[[nodiscard]] EffectSet asked_effects(const design::DesignSettings& design) noexcept;

/// The design as if it asked for an effect that needs nothing but to be asked for: air, blur of what is out of focus, smooth
/// edges. Others change nothing.
[[nodiscard]] design::DesignSettings with_effect(const design::DesignSettings& design, Effect effect) noexcept;
/// The design as if it did not ask for an effect.
[[nodiscard]] design::DesignSettings without_effect(const design::DesignSettings& design, Effect effect) noexcept;

/// Something else is found in the distances of the picture, so that there is no blur round foci.
[[nodiscard]] bool reads_distances(const design::DesignSettings& design) noexcept;

/// What can take another's place in a running display of this design, as possible_design() gives it: what is compiled in anyway.
[[nodiscard]] EffectSet effects_in_reserve(const design::DesignSettings& possible) noexcept;

/// What takes an effect's place, by the design; a display's start refuses one that cannot be had.
[[nodiscard]] ReplacementOrder order_of(const design::DesignSettings& design) noexcept;

/// The design with what a device cannot do, or must not, in the way that stands for it there.
[[nodiscard]] design::DesignSettings possible_design(const design::DesignSettings& design, const DeviceSettings& device);

}  // namespace tedavis::effects
