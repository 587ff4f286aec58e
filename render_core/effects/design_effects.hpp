/// The effects that a design requests, the design with one effect added or removed, and the design as a device can show it, by
/// the rows of effect_table.cpp. Pure; any thread.
#pragma once

#include "render_core/effects/device.hpp"
#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {

/// Returns the design with what it leaves to the device decided: edges are smoothed where the device can afford it.
[[nodiscard]] design::DesignSettings design_on(const DeviceSettings& device, const design::DesignSettings& design) noexcept;

/// Returns the effects that a design requests, whether or not they are possible. What it leaves to the device is not requested
/// before design_on() decides it.
[[nodiscard]] EffectSet asked_effects(const design::DesignSettings& design) noexcept;

/// Returns the design with a further effect requested. Only effects that need no other settings can be added, such as air,
/// depth of field and antialiasing; others change nothing.
[[nodiscard]] design::DesignSettings with_effect(const design::DesignSettings& design, Effect effect) noexcept;
/// Returns the design without a request for an effect.
[[nodiscard]] design::DesignSettings without_effect(const design::DesignSettings& design, Effect effect) noexcept;

/// True where another effect uses the picture's distance buffer, so that blur round foci is not available.
[[nodiscard]] bool reads_distances(const design::DesignSettings& design) noexcept;

/// Returns the effects that can replace others in a running display of this design (as possible_design() returns it), because
/// their programs are compiled in.
[[nodiscard]] EffectSet effects_in_reserve(const design::DesignSettings& possible) noexcept;

/// Returns the design's replacements of effects; a display's start refuses impossible ones.
[[nodiscard]] ReplacementOrder order_of(const design::DesignSettings& design) noexcept;

/// Returns the design, as design_on() returns it, with every effect that the device cannot do, or must not, changed to its
/// replacement.
[[nodiscard]] design::DesignSettings possible_design(const design::DesignSettings& design, const DeviceSettings& device);

}  // namespace tedavis::effects
